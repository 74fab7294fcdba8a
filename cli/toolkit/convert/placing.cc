// SPDX-License-Identifier: BSD-3-Clause
#include "placing.h"

#include <fca/formats/text/message.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace fca {

namespace {

namespace fs = std::filesystem;

/// What people expect behind a name.
struct Extension {
  std::string_view extension;
  std::string_view syntax;
};

constexpr std::array kExtensions = {Extension{".yaml", "YAML"}, Extension{".yml", "YAML"}, Extension{".xml", "XML"},
                                    Extension{".json", "JSON"}, Extension{".txt", "text"}, Extension{".ini", "text"}};

std::string_view name_of(text::Syntax syntax) {
  switch (syntax) {
    case text::Syntax::kXml:
      return "XML";
    case text::Syntax::kJson:
      return "JSON";
    case text::Syntax::kWords:
      return "text";
    case text::Syntax::kYaml:
    case text::Syntax::kOpenCvYaml:
      break;
  }
  return "YAML";
}

std::string misnamed(const std::string& path, const text::Syntax syntax) {
  const std::string_view is = name_of(syntax);
  const std::string extension = fs::path(path).extension().string();
  const auto known = std::ranges::find(kExtensions, extension, &Extension::extension);
  if (known == kExtensions.end() || known->syntax == is) return "";
  return path + " holds " + std::string(is) + ", whatever its name says: its readers go by the content";
}

/// False with an error where there is no place for so many files.
bool has_room(const ConvertRequest& request, ConvertResult& result) {
  const std::size_t with_cameras = camera_files(result.files);
  if (!request.room.named_files && std::ranges::any_of(result.files, &ConvertedFile::named)) {
    result.diagnostics.error("one-output",
                             text::text_of(result.headline) + ": these are " + std::to_string(result.files.size()) + " files",
                             {}, "-o FOLDER/, or -o FILE, which has the others beside it");
  } else if (!request.room.camera_files && with_cameras > 1) {
    result.diagnostics.error(
        "one-camera-per-file",
        // An OpenCV file of camera_calibration's keys, for one, though there are others for several cameras.
        (result.to->many_cameras ? text::text_of(result.headline) + ": one" : std::string(result.to->title) + " holds one") +
            " camera per file, and here are " + std::to_string(with_cameras),
        {},
        "-o FOLDER/, a pattern such as -o '{stem}.{camera}" + extension_of(result.files.front(), *result.to) +
            "', or --camera to choose one");
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
    std::erase_if(result.defaults, [&name](const DefaultedValue& value) { return value.key.ends_with("(" + name + ")"); });
    result.losses.push_back({"second-file-dropped", name + " (the IMU's noise and rate)",
                             "a camchain has no place for it and there is one output",
                             "-o FOLDER/ writes it beside the camchain"});
    result.files.erase(result.files.begin() + static_cast<std::ptrdiff_t>(i));
  }
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
  for (std::size_t i = 0; request.path_of && i < result.files.size(); ++i) {
    ConvertedFile& file = result.files[i];
    file.path = request.path_of(result, i);
    const std::string problem = misnamed(file.path, file.syntax);
    if (!problem.empty() && file.path != request.into) result.diagnostics.note("extension", problem);
  }
  return true;
}

}  // namespace fca
