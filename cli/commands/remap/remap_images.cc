// SPDX-License-Identifier: BSD-3-Clause
#include "remap_images.h"

#include "pictures/image_file.h"
#include "pictures/image_formats.h"
#include "pictures/pictures.h"
#include "shell/held_interrupt.h"
#include "shell/kept_inputs.h"
#include "shell/option_hints.h"
#include "shell/output_name.h"
#include "shell/progress.h"
#include "shell/put_files.h"
#include "toolkit/parallel_for.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>

#include <array>
#include <filesystem>
#include <set>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// Of standard output its name, for messages.
std::string output_path(const OutputPlace& place, const std::string& input, const std::string& camera) {
  switch (place.kind) {
    case OutputPlace::Kind::kPattern:
      return with_names_of(input, camera, place.path);
    case OutputPlace::Kind::kFolder:
      return (fs::path(place.path) / fs::path(input).filename()).string();
    case OutputPlace::Kind::kFile:
      return place.path;
    case OutputPlace::Kind::kNotSaid:
    case OutputPlace::Kind::kStandardOutput:
      break;
  }
  return "-";
}

/// Whose ending says the format: the output's, or the input's where that has none (standard output, a device).
std::string extension_for(const std::string& output, const std::string& input) {
  const std::string extension = fs::path(output).extension().string();
  return extension.empty() ? fs::path(input).extension().string() : extension;
}

void remap_image(const RemapArguments& arguments, const Camera& source, const ImageMap& map, const Console& console,
                 RemappedImage& result) {
  const auto refuse = [&](ExitCode code, const Message& why) {
    result.diagnostics.add(why, {result.input, 0, 0});
    result.code = code;
  };
  const std::optional<Image> image = read_image_file(result.input, result.diagnostics);
  if (!image ||
      !has_size_of(source, !arguments.request.inputs.change.changes_nothing(), *image, result.input, result.diagnostics)) {
    result.code = exit_code(status_of(result.diagnostics));
    return;
  }
  const std::string extension = extension_for(result.output, result.input);
  if (const std::optional<std::string> problem = problem_with_format(*image, extension))
    return refuse(ExitCode::kUsage, {Code::kImageFormatUnfit, {*problem}});
  const std::optional<Image> seen = cli::remapped(*image, map, arguments.interpolation);
  const std::optional<std::string> bytes = seen ? encoded(*seen, extension) : std::nullopt;
  if (!bytes) return refuse(ExitCode::kBadInput, {Code::kImageNotMapped, {extension}});
  if (arguments.output.is_standard_output()) {
    console.out(*bytes);
    return;
  }
  make_folder_of(result.output, arguments.output);
  const OutputFile file{result.output, *bytes};
  if (const std::optional<Message> failure = put_files(std::span(&file, 1), arguments.force, console))
    refuse(ExitCode::kIo, *failure);
}

}  // namespace

std::optional<std::string> problem_with_output(const RemapArguments& arguments, std::span<const FoundFile> images,
                                               const std::string& camera) {
  const bool many = images.size() > 1 || (images.size() == 1 && !images.front().named);
  if (many && !arguments.output.holds_many()) return "several images need -o FOLDER/ or a pattern such as -o 'out/{stem}.png'";
  std::vector<std::string> files = arguments.request.inputs.files;
  for (const FoundFile& image : images) files.push_back(image.path);
  KeptInputs inputs(arguments.request.inputs);
  inputs.add(files);
  for (const std::string& path : {arguments.map, arguments.mask}) {
    if (std::optional<std::string> problem = inputs.problem_with(path)) return problem;
  }
  std::set<std::string> taken;
  for (const FoundFile& image : images) {
    const std::string path = output_path(arguments.output, image.path, camera);
    const std::string extension = extension_for(path, image.path);
    if (!is_image_extension(extension)) {
      return "'" + path + "' does not end as an image that is written; there are " + image_extensions();
    }
    if (path == arguments.map || path == arguments.mask) return path + " is named twice, for an image and for --map or --mask";
    if (!taken.insert(path).second)
      return "two outputs would be written to " + path + "; a pattern with {folder}, {stem} and {extension} tells them apart";
    if (std::optional<std::string> problem = inputs.problem_with(path)) return problem;
  }
  return std::nullopt;
}

std::vector<RemappedImage> remap_images(const RemapArguments& arguments, std::span<const FoundFile> images,
                                        const Camera& source, const ImageMap& map, const Console& console) {
  std::vector<RemappedImage> results(images.size());
  const HeldInterrupt interrupt(images.size() > 1, console);
  Progress progress(images.size(), console.streams().err);
  parallel_for(images.size(), arguments.request.jobs, [&](std::size_t i) {
    results[i].input = images[i].path;
    results[i].output = output_path(arguments.output, images[i].path, source.name);
    results[i].left = interrupt.asked();
    if (!results[i].left) remap_image(arguments, source, map, console, results[i]);
    progress.step();
  });
  return results;
}

}  // namespace fca::cli
