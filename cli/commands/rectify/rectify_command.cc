// SPDX-License-Identifier: BSD-3-Clause
#include "rectify_command.h"

#include "commands/remap/npy.h"
#include "options/command_line.h"
#include "pictures/image_formats.h"
#include "pictures/pictures.h"
#include "shell/kept_inputs.h"
#include "shell/option_hints.h"
#include "shell/put_files.h"
#include "shell/words.h"

#include <fca/formats/file_name.h>
#include <fca/formats/text/message.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kSides = {"left", "right"};

/// One side's images as `remap` takes them.
RemapArguments side_of(const RectifyArguments& arguments, std::size_t side) {
  RemapArguments result;
  result.request.inputs = arguments.request.inputs;
  result.request.jobs = arguments.request.jobs;
  result.images = side == 0 ? arguments.left : arguments.right;
  result.interpolation = arguments.interpolation;
  result.output = {OutputPlace::Kind::kFolder, (fs::path(arguments.output.path) / kSides.at(side)).string() + "/"};
  result.force = arguments.force;
  return result;
}

/// Text is compressed where it would take tens of megabytes.
std::string map_extension(MapFormat format, const ImageMap& map) {
  if (format == MapFormat::kNpy) return ".npy";
  constexpr std::int64_t kManyPixels = 1'000'000;
  return std::int64_t{map.size.width} * map.size.height > kManyPixels ? ".yml.gz" : ".yml";
}

/// Nothing where OpenCV cannot make it.
std::string bytes_of(const ImageMap& map, MapFormat format) {
  if (format == MapFormat::kNpy) return npy(map);
  const MapNumbers numbers = format == MapFormat::kFloat ? MapNumbers::kFloat : MapNumbers::kFixedPoint;
  return map_file(map, numbers, map_extension(format, map).ends_with(".gz")).value_or("");
}

/// Settings and maps, by their paths.
std::vector<OutputFile> files_of(const RectifyArguments& arguments, Rectifying& done) {
  std::vector<OutputFile> files;
  const bool folder = arguments.output.kind == OutputPlace::Kind::kFolder;
  const fs::path path = arguments.output.path;
  if (arguments.output.is_said() && !arguments.output.is_standard_output()) {
    for (const ConvertedFile& file : done.result.files) {
      const std::string name = as_file_name(fs::path(file.name).filename().string());
      done.settings.push_back(folder ? (path / name).string() : path.string());
      files.push_back({done.settings.back(), file.bytes});
    }
  }
  const bool writes_maps = arguments.maps && done.result.maps.size() == 2;
  for (std::size_t i = 0; i < 2 && writes_maps; ++i) {
    const ImageMap& map = done.result.maps[i];
    done.maps.push_back((path / (std::string(kSides.at(i)) + "_map" + map_extension(arguments.map_format, map))).string());
    files.push_back({done.maps.back(), bytes_of(map, arguments.map_format)});
  }
  return files;
}

std::optional<std::string> problem_with_files(const RectifyArguments& arguments, const std::vector<OutputFile>& files,
                                              const Console& console) {
  const KeptInputs inputs(console, arguments.request.inputs);
  for (const OutputFile& file : files) {
    if (std::optional<std::string> problem = inputs.problem_with(file.path)) return problem;
  }
  const bool is_one_place = !arguments.output.holds_many();
  if (is_one_place && arguments.request.to != nullptr && files.size() > 1) return "several files of settings need -o FOLDER/";
  return std::nullopt;
}

ExitCode tell(const RectifyArguments& arguments, const Rectifying& done, const Console& console) {
  ExitCode code = exit_code(done.result.status);
  for (const std::vector<RemappedImage>& side : done.images) {
    for (const RemappedImage& image : side) {
      console.show(image.diagnostics);
      code = worse(code, image.code);
    }
  }
  if (arguments.json) {
    console.out(rectify_json(arguments, done, code, console));
    return code;
  }
  const bool prints_settings = !done.result.files.empty() && done.settings.empty() && code == ExitCode::kGood;
  if (!prints_settings) {
    console.say(rectify_text(arguments, done));
    return code;
  }
  console.print_stderr(rectify_text(arguments, done));
  console.out(done.result.files.front().bytes);
  return code;
}

ExitCode run_rectify(const RectifyArguments& given, const TypedOptions& typed, Console& console) {
  RectifyArguments arguments = given;
  RectifyRequest& request = arguments.request;
  request.made_by =
      command_line(typed, "rectify", [](const TypedOption& option) { return !option.positional && !option.about_output; });
  if (arguments.like_opencv) request.like_opencv = &stereo_rectified;
  std::array<std::vector<FoundFile>, 2> images;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<std::string>& paths = i == 0 ? arguments.left : arguments.right;
    if (paths.empty()) continue;
    if (const std::optional<std::string> problem = problem_with_patterns(paths)) return console.refuse(ExitCode::kIo, *problem);
    images.at(i) = walk(paths, &is_image_extension);
    if (images.at(i).empty()) return console.refuse(ExitCode::kBadInput, "no image in " + enumerated(paths));
  }
  Rectifying done;
  done.result = rectify(request, console.files());
  if (done.result.status > Status::kRejected) return console.refuse(exit_code(done.result.status), done.result.diagnostics);
  const std::vector<OutputFile> files = files_of(arguments, done);
  if (std::ranges::any_of(files, [](const OutputFile& file) { return file.bytes.empty(); }))
    return console.refuse(ExitCode::kIo, "OpenCV cannot write these maps");
  if (const std::optional<std::string> problem = problem_with_files(arguments, files, console))
    return console.refuse(ExitCode::kUsage, *problem);
  if (!done.result.files.empty() && done.settings.empty() && done.result.files.size() > 1 && !arguments.json)
    return console.refuse(ExitCode::kUsage, "several files of settings need -o FOLDER/");
  for (std::size_t i = 0; i < 2; ++i) {
    const std::optional<std::string> problem =
        problem_with_output(side_of(arguments, i), images.at(i), done.result.cameras.at(i).name);
    if (problem && !images.at(i).empty()) return console.refuse(ExitCode::kUsage, *problem);
  }
  console.show(done.result.diagnostics);
  if (done.result.status == Status::kRejected) {
    done.settings.clear();
    return tell(arguments, done, console);
  }
  for (const OutputFile& file : files) make_folder_of(file.path, arguments.output);
  if (const std::optional<Message> failure = put_files(files, arguments.force, console))
    return console.refuse(ExitCode::kIo, text::text_of(*failure, with_options));
  for (std::size_t i = 0; i < 2; ++i) {
    if (images.at(i).empty()) continue;
    done.images.at(i) =
        remap_images(side_of(arguments, i), images.at(i), done.result.cameras.at(i), done.result.maps.at(i), console);
  }
  return tell(arguments, done, console);
}

}  // namespace

void add_rectify_command(Application& application) {
  application.add<RectifyArguments>("rectify", "A stereo pair rectified: its settings, maps and images", &add_rectify_options,
                                    &run_rectify);
}

}  // namespace fca::cli
