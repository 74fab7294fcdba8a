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

/// The syntax that users expect in a file with this extension.
struct ExpectedSyntax {
  std::string_view extension;
  std::string_view syntax;
};

constexpr std::array kExpected = {ExpectedSyntax{".yaml", "YAML"},  ExpectedSyntax{".yml", "YAML"},
                                  ExpectedSyntax{".xml", "XML"},    ExpectedSyntax{".json", "JSON"},
                                  ExpectedSyntax{".txt", "text"},   ExpectedSyntax{".ini", "text"},
                                  ExpectedSyntax{".bin", "binary"}, ExpectedSyntax{".cameramodel", "Python"}};

std::string_view syntax_name(text::Syntax syntax) {
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
      return "YAML";
  }
  return "";
}

/// True if users expect another syntax in a file of that name.
bool is_misnamed(const std::string& path, text::Syntax syntax) {
  const std::string extension = fs::path(path).extension().string();
  const auto known = std::ranges::find(kExpected, extension, &ExpectedSyntax::extension);
  return known != kExpected.end() && known->syntax != syntax_name(syntax);
}

/// If the user gave further parts of the input (an IMU file) and the output takes no files without cameras: returns the first
/// file without cameras, which would contain that part. Null if there is none, or if the request allows it to be left out.
const ConvertedFile* given_part_without_room(const ConvertRequest& request, const ConvertResult& result) {
  const bool may_be_missing = request.room.further_files || request.room.given_parts;
  if (may_be_missing || request.inputs.parts.empty()) return nullptr;
  const auto part = std::ranges::find_if(result.files, [](const ConvertedFile& file) { return file.cameras.empty(); });
  return part == result.files.end() ? nullptr : &*part;
}

/// True if the output can take all files of the result that must not be left out. Otherwise adds an error.
bool has_room(const ConvertRequest& request, ConvertResult& result) {
  const std::size_t with_cameras = camera_files(result.files);
  if (!request.room.named_files && std::ranges::any_of(result.files, &ConvertedFile::named)) {
    result.diagnostics.add(Code::kSeveralFiles, {result.headline, result.files.size()});
  } else if (!request.room.camera_files && with_cameras > 1) {
    // The files of some formats hold several cameras in one layout and only one in another (OpenCV's files with the keys of
    // camera_calibration). The message then names the layout.
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

/// Removes all files without cameras, except the first file of the list. Reports a removed file as a loss if it contained facts
/// of the input. Removes the defaults of these files from result.defaults.
void remove_further_files(ConvertResult& result) {
  for (std::size_t i = result.files.size(); i-- > 1;) {
    if (!result.files[i].cameras.empty()) continue;
    const std::string name = result.files[i].name;
    std::erase_if(result.defaults, [&name](const DefaultedValue& value) { return value.file == name; });
    if (!result.files[i].of_defaults) result.losses.push_back(lost(Code::kImuFileDropped, name, ""));
    result.files.erase(result.files.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// COLMAP stores each file of a model as .txt or as .bin. Returns the path of the other form of the file, or an empty path for
/// other extensions.
fs::path other_form_of(const fs::path& path) {
  if (path.extension() == ".txt") return fs::path(path).replace_extension(".bin");
  if (path.extension() == ".bin") return fs::path(path).replace_extension(".txt");
  return {};
}

bool exists_on_disk(const fs::path& path) {
  std::error_code ignored;
  return !path.empty() && fs::exists(path, ignored);
}

/// The path of the first file on the disk that is the other form of a file to be written. A program might read that one, or
/// both.
std::optional<std::string> other_form_on_disk(const std::vector<ConvertedFile>& files) {
  for (const ConvertedFile& file : files) {
    if (file.is_filler() || file.place.empty() || fs::path(file.path).filename() != file.place) continue;
    if (const fs::path other = other_form_of(file.path); exists_on_disk(other)) return other.string();
  }
  return std::nullopt;
}

}  // namespace

std::string extension_of(const ConvertedFile& file, const Format& format) {
  const fs::path proposal = file.name;
  return proposal.has_extension() ? proposal.extension().string() : std::string(format.extension);
}

bool is_calibration_extension(std::string_view extension) {
  return std::ranges::find(kExpected, extension, &ExpectedSyntax::extension) != kExpected.end();
}

std::size_t camera_files(const std::vector<ConvertedFile>& files) {
  return static_cast<std::size_t>(
      std::ranges::count_if(files, [](const ConvertedFile& file) { return !file.cameras.empty() && !file.named; }));
}

bool place_files(const ConvertRequest& request, ConvertResult& result) {
  if (!has_room(request, result)) return false;
  if (!request.room.further_files) remove_further_files(result);
  if (!request.room.fillers) {
    const std::size_t removed = std::erase_if(result.files, [](const ConvertedFile& file) { return file.is_filler(); });
    // A single remaining file needs no folder of its program, so that any name will do.
    if (removed > 0 && result.files.size() == 1) result.files.front().place.clear();
  }
  for (std::size_t i = 0; request.path_of && i < result.files.size(); ++i) {
    ConvertedFile& file = result.files[i];
    file.path = request.path_of(result, i);
    const bool is_file_of_user = file.path == request.into;
    if (!is_file_of_user && is_misnamed(file.path, file.syntax))
      result.diagnostics.add(Code::kMisnamed, {file.path, syntax_name(file.syntax)});
  }
  const std::optional<std::string> other = request.into.empty() ? other_form_on_disk(result.files) : std::nullopt;
  if (other) {
    result.diagnostics.add(Code::kOtherFormInFolder, {*other});
    result.status = Status::kBadRequest;
    return false;
  }
  // Do not replace a filler that exists on the disk, in either form: it may contain the user's work.
  std::erase_if(result.files, [](const ConvertedFile& file) {
    return file.is_filler() && !file.path.empty() && (exists_on_disk(file.path) || exists_on_disk(other_form_of(file.path)));
  });
  return true;
}

}  // namespace fca
