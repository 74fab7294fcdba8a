// SPDX-License-Identifier: BSD-3-Clause
#include "remap_command.h"

#include "commands/convert/batch.h"
#include "npy.h"
#include "pictures/image_formats.h"
#include "pictures/pictures.h"
#include "remap_images.h"
#include "shell/diagnostics_json.h"
#include "shell/option_hints.h"
#include "shell/parameters_json.h"
#include "shell/put_files.h"
#include "shell/words.h"

#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>

namespace fca::cli {

namespace {

struct Remapping {
  RemapResult result;
  std::vector<RemappedImage> images;
};

/// --map and --mask
std::optional<std::string> write_parts(const RemapArguments& arguments, const ImageMap& map,
                                       const std::vector<std::uint8_t>& mask, const Console& console) {
  std::vector<OutputFile> files;
  if (!arguments.map.empty()) files.push_back({arguments.map, npy(map)});
  if (!arguments.mask.empty()) {
    std::optional<std::string> bytes = encoded({map.size.width, map.size.height, 1, Image::Sample::k8Bit, mask}, ".png");
    if (!bytes) return "cannot make " + arguments.mask;
    files.push_back({arguments.mask, *std::move(bytes)});
  }
  const std::optional<Message> failure = put_files(files, arguments.force, console);
  return failure ? std::optional(text::text_of(*failure, with_options)) : std::nullopt;
}

std::string view_model(const RemapResult& result) {
  return result.is_equirectangular ? "equirectangular" : std::string(model_info(result.view.model).id);
}

std::string view_text(const RemapArguments& arguments, const RemapResult& result) {
  const Camera& view = result.view;
  std::string text = result.source.name + ", " + std::string(model_info(result.source.model).id) + ", " +
                     size_in_words(*result.source.image_size) + " px, as " + view_model(result) + ", " +
                     size_in_words(*view.image_size) + " px";
  if (const std::optional<Turn>& turn = arguments.request.turn) {
    const auto degrees = [](double angle_rad) { return text::format_short(angle_rad * kDegreesPerRadian, 6); };
    text += ", turned by " + degrees(turn->yaw_rad) + "," + degrees(turn->pitch_rad) + "," + degrees(turn->roll_rad) +
            " deg (yaw, pitch, roll)";
  }
  return text + "\n" +
         (result.is_equirectangular ? "  in COLMAP's cameras.txt: " + result.colmap_camera + "\n"
                                    : parameters_in_words(view.model, "  ")) +
         "  the source sees " + percent(result.seen_share) + " of it\n";
}

bool is_written(const RemappedImage& image) { return !image.left && image.code == ExitCode::kGood; }

std::string images_text(const RemapArguments& arguments, const Remapping& done) {
  std::string text;
  for (const std::string& path : {arguments.map, arguments.mask}) {
    if (!path.empty()) text += "wrote " + path + "\n";
  }
  std::ptrdiff_t written = 0;
  for (const RemappedImage& image : done.images) {
    if (!is_written(image)) continue;
    ++written;
    if (!arguments.output.is_standard_output() && is_reported_in_full(done.images.size()))
      text += "wrote " + fca::text::printable(image.output) + "\n";
  }
  const bool interrupted = std::ranges::any_of(done.images, &RemappedImage::left);
  if (!is_reported_in_full(done.images.size()) || interrupted) {
    text += std::string(interrupted ? "interrupted: " : "") + std::to_string(written) + " of " +
            std::to_string(done.images.size()) + " images written\n";
  }
  return text;
}

std::string json_of(const RemapArguments& arguments, const Remapping& done, ExitCode code, const Console& console) {
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.put("file", arguments.request.inputs.files.front());
    json.put("camera", done.result.source.name);
    json.put("exit_code", static_cast<int>(code));
    json.object("view", [&] {
      json.put("model", view_model(done.result));
      done.result.is_equirectangular ? json.object("parameters", [] {}) : put_parameters(json, done.result.view.model);
      json.put("width", done.result.view.image_size->width);
      json.put("height", done.result.view.image_size->height);
      json.put("T_source_view", std::span<const double>(done.result.T_source_view.values));
    });
    json.put("seen_share", done.result.seen_share);
    arguments.map.empty() ? json.null("map") : json.put("map", arguments.map);
    arguments.mask.empty() ? json.null("mask") : json.put("mask", arguments.mask);
    json.array("images", done.images, [&](const RemappedImage& image) {
      json.object([&] {
        json.put("input", image.input);
        is_written(image) ? json.put("output", image.output) : json.null("output");
        put_diagnostics(json, image.diagnostics, console);
      });
    });
    put_diagnostics(json, done.result.diagnostics, console);
  });
  return json.document();
}

/// What was done, at the end.
ExitCode tell(const RemapArguments& arguments, const Remapping& done, const Console& console) {
  ExitCode code = ExitCode::kGood;
  for (const RemappedImage& image : done.images) {
    console.show(image.diagnostics);
    code = worse(code, image.code);
  }
  if (arguments.json) {
    console.out(json_of(arguments, done, code, console));
    return code;
  }
  const bool wrote_parts = !arguments.map.empty() || !arguments.mask.empty();
  const bool made = wrote_parts || done.images.empty() || std::ranges::any_of(done.images, &is_written);
  const std::string text = (made ? view_text(arguments, done.result) : "") + images_text(arguments, done);
  arguments.output.kind == OutputPlace::Kind::kStandardOutput ? console.print_stderr(text) : console.say(text);
  return code;
}

ExitCode run_remap(const RemapArguments& arguments, Console& console) {
  if (const std::optional<std::string> problem = problem_with_patterns(arguments.images))
    return console.refuse(ExitCode::kIo, *problem);
  const std::vector<FoundFile> images =
      arguments.images.empty() ? std::vector<FoundFile>() : walk(arguments.images, &is_image_extension);
  if (images.empty() && !arguments.images.empty())
    return console.refuse(ExitCode::kBadInput, "no image in " + enumerated(arguments.images));
  Remapping done;
  done.result = remap(arguments.request, console.files());
  const RemapResult& result = done.result;
  if (result.status > Status::kRejected) return console.refuse(exit_code(result.status), result.diagnostics);
  if (const std::optional<std::string> error = problem_with_output(arguments, images, result.source.name))
    return console.refuse(ExitCode::kUsage, *error);
  if (result.status == Status::kRejected)
    return console.refuse(ExitCode::kRejected, result.source.name + " sees nothing of that view; nothing is written");
  console.show(result.diagnostics);
  if (const std::optional<std::string> failure = write_parts(arguments, result.map, result.mask, console))
    return console.refuse(ExitCode::kIo, *failure);
  done.images = remap_images(arguments, images, result.source, result.map, console);
  return tell(arguments, done, console);
}

}  // namespace

void add_remap_command(Application& application) {
  application.add<RemapArguments>("remap",
                                  "Images as another camera would have taken them: undistorted, as another model, turned",
                                  &add_remap_options, &run_remap);
}

}  // namespace fca::cli
