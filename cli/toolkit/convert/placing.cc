// SPDX-License-Identifier: BSD-3-Clause
#include "placing.h"

#include <fca/code.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fca {

namespace {

namespace fs = std::filesystem;

/// What people expect behind a name.
struct Extension {
  std::string_view extension;
  std::string_view syntax;
};

constexpr std::array kExtensions = {Extension{".yaml", "YAML"},  Extension{".yml", "YAML"},          Extension{".xml", "XML"},
                                    Extension{".json", "JSON"},  Extension{".txt", "text"},          Extension{".ini", "text"},
                                    Extension{".bin", "binary"}, Extension{".cameramodel", "Python"}};

std::string_view name_of(text::Syntax syntax) {
  switch (syntax) {
    case text::Syntax::kXml:
      return "XML";
    case text::Syntax::kJson:
      return "JSON";
    case text::Syntax::kPython:
      return "Python";
    case text::Syntax::kWords:
      return "text";
    case text::Syntax::kBinary:
      return "binary";
    case text::Syntax::kYaml:
    case text::Syntax::kOpenCvYaml:
      break;
  }
  return "YAML";
}

bool is_misnamed(const std::string& path, text::Syntax syntax) {
  const std::string extension = fs::path(path).extension().string();
  const auto known = std::ranges::find(kExtensions, extension, &Extension::extension);
  return known != kExtensions.end() && known->syntax != name_of(syntax);
}

/// The file without cameras (an IMU's) that would be left out though the input's parts were given for it; null if there is
/// none.
const ConvertedFile* given_part_without_room(const ConvertRequest& request, const ConvertResult& result) {
  if (request.room.further_files || request.room.given_parts || request.inputs.parts.empty()) return nullptr;
  const auto part = std::ranges::find_if(result.files, [](const ConvertedFile& file) { return file.cameras.empty(); });
  return part == result.files.end() ? nullptr : &*part;
}

/// False with an error where there is no place for so many files.
bool has_room(const ConvertRequest& request, ConvertResult& result) {
  const std::size_t with_cameras = camera_files(result.files);
  if (!request.room.named_files && std::ranges::any_of(result.files, &ConvertedFile::named)) {
    result.diagnostics.add(Code::kSeveralFiles, {result.headline, result.files.size()});
  } else if (!request.room.camera_files && with_cameras > 1) {
    // An OpenCV file of camera_calibration's keys is for one, though there are others for several cameras.
    const Message one = result.to->many_cameras ? Message{Code::kOfHeadlineOne, {result.headline}}
                                                : Message{Code::kHoldsOne, {result.to->title}};
    result.diagnostics.add(Code::kOneCameraPerFile, {one, with_cameras, extension_of(result.files.front(), *result.to)},
                           {request.inputs.files.front(), 0, 0});
  } else if (const ConvertedFile* part = given_part_without_room(request, result)) {
    result.diagnostics.add(Code::kPartHasNoRoom, {result.to->title, part->name});
  } else {
    return true;
  }
  result.status = Status::kBadRequest;
  return false;
}

/// The files without cameras, after the first, become losses.
void leave_out_further_files(ConvertResult& result) {
  for (std::size_t i = result.files.size(); i-- > 1;) {
    if (!result.files[i].cameras.empty()) continue;
    const std::string name = result.files[i].name;
    std::erase_if(result.defaults, [&name](const DefaultedValue& value) { return value.file == name; });
    if (!result.files[i].of_defaults) result.losses.push_back(lost(Code::kImuFileDropped, name, ""));
    result.files.erase(result.files.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// A model lies in its folder as text or as binary: the path of the same file in the other form; empty: it has none.
fs::path twin_of(const fs::path& path) {
  if (path.extension() == ".txt") return fs::path(path).replace_extension(".bin");
  if (path.extension() == ".bin") return fs::path(path).replace_extension(".txt");
  return {};
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return !path.empty() && fs::exists(path, ignored);
}

/// A file that the folder of a file to be written holds in the other form.
std::optional<std::string> other_form_of(const std::vector<ConvertedFile>& files) {
  for (const ConvertedFile& file : files) {
    const bool has_place = !file.is_filler() && !file.place.empty() && fs::path(file.path).filename() == file.place;
    if (const fs::path twin = twin_of(file.path); has_place && is_there(twin)) return twin.string();
  }
  return std::nullopt;
}

}  // namespace

std::string extension_of(const ConvertedFile& file, const Format& format) {
  const fs::path proposal = file.name;
  return proposal.has_extension() ? proposal.extension().string() : std::string(format.extension);
}

bool is_calibration_extension(std::string_view extension) {
  return std::ranges::find(kExtensions, extension, &Extension::extension) != kExtensions.end();
}

std::size_t camera_files(const std::vector<ConvertedFile>& files) {
  return static_cast<std::size_t>(
      std::ranges::count_if(files, [](const ConvertedFile& file) { return !file.cameras.empty() && !file.named; }));
}

bool place_files(const ConvertRequest& request, ConvertResult& result) {
  if (!has_room(request, result)) return false;
  if (!request.room.further_files) leave_out_further_files(result);
  if (!request.room.fillers) {
    const std::size_t gone = std::erase_if(result.files, [](const ConvertedFile& file) { return file.is_filler(); });
    // Alone it is nobody's folder.
    if (gone > 0 && result.files.size() == 1) result.files.front().place.clear();
  }
  for (std::size_t i = 0; request.path_of && i < result.files.size(); ++i) {
    ConvertedFile& file = result.files[i];
    file.path = request.path_of(result, i);
    if (file.path != request.into && is_misnamed(file.path, file.syntax))
      result.diagnostics.add(Code::kMisnamed, {file.path, name_of(file.syntax)});
  }
  const std::optional<std::string> other = request.into.empty() ? other_form_of(result.files) : std::nullopt;
  if (other) {
    result.diagnostics.add(Code::kOtherFormInFolder, {*other});
    result.status = Status::kBadRequest;
    return false;
  }
  // What the program's folder has already, as text or binary, is somebody's work.
  std::erase_if(result.files, [](const ConvertedFile& file) {
    return file.is_filler() && !file.path.empty() && (is_there(file.path) || is_there(twin_of(file.path)));
  });
  return true;
}

}  // namespace fca
