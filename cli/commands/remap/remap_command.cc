// SPDX-License-Identifier: BSD-3-Clause
#include "remap_command.h"

#include "commands/convert/batch.h"
#include "npy.h"
#include "options/subcommand.h"
#include "pictures/image_formats.h"
#include "pictures/pictures.h"
#include "remap_images.h"
#include "shell/diagnostics_json.h"
#include "shell/output_file.h"
#include "shell/parameters_json.h"
#include "shell/words.h"
#include "toolkit/at_once.h"
#include "toolkit/remap_view.h"

#include <fca/remap/image_map.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

std::optional<std::string> problem_with(const RemapArguments& arguments) {
  if (const std::optional<std::string> error = check(arguments.reading)) return error;
  if (const std::optional<std::string> error = problem_with_view(arguments)) return error;
  if (arguments.interpolation != "bilinear" && arguments.interpolation != "lanczos")
    return "unknown interpolation '" + arguments.interpolation + "'; there are bilinear and lanczos";
  const std::string mask_extension = std::filesystem::path(arguments.mask).extension().string();
  if (!arguments.mask.empty() && mask_extension != ".png") return "--mask wants a .png file";
  if (!arguments.map.empty() && !arguments.map.ends_with(".npy")) return "--map wants a .npy file, which NumPy reads";
  return std::nullopt;
}

/// The camera whose images they are; nothing with an error where the file has none, or several.
std::optional<Camera> source_of(const RemapArguments& arguments, Console& console, Diagnostics& diagnostics) {
  const std::optional<Calibration> calibration = read_input(arguments.file, arguments.reading, console, diagnostics);
  if (!calibration) return std::nullopt;
  const std::vector<Camera>& cameras = calibration->rig.cameras;
  const auto refuse = [&](const char* code, const std::string& message, const std::string& fix = {}) {
    diagnostics.error(code, message, {arguments.file, 0, 0}, fix);
    return std::nullopt;
  };
  if (cameras.empty()) return refuse("no-camera", "the file holds no camera");
  if (cameras.size() > 1) {
    return refuse("unknown-camera", "the file holds " + std::to_string(cameras.size()) + " cameras; whose images are these?",
                  "choose one with --camera");
  }
  if (!cameras.front().image_size) return refuse("no-size", "the file states no image size", "say it with --size WxH");
  return cameras.front();
}

bool sides_are_mapped(const Camera& camera, Diagnostics& diagnostics) {
  constexpr int kLongest = 32766;  // cv::remap counts in 16 bits
  if (!camera.image_size) {
    diagnostics.error("no-size", camera.name + " has no image size", {}, "--like wants a file that states one");
    return false;
  }
  const auto& [width, height] = *camera.image_size;
  if (std::max(width, height) <= kLongest && std::int64_t{width} * height <= kMostPixels) return true;
  diagnostics.error("image-size", "images of " + size_in_words(*camera.image_size) + " px are too large to be remapped", {},
                    "sides up to " + std::to_string(kLongest) + " px, and 134 megapixels");
  return false;
}

/// Rows at the same time.
ImageMap map_of(const ImageMapper& mapper, std::size_t jobs) {
  const ImageSize size = mapper.size();
  const auto stride = 2 * static_cast<std::size_t>(size.width);
  const auto rows = static_cast<std::size_t>(size.height);
  ImageMap map{size, std::vector<float>(stride * rows)};
  constexpr std::size_t kRows = 16;  // of one piece of work
  at_once((rows + kRows - 1) / kRows, jobs, [&](std::size_t piece) {
    for (std::size_t row = piece * kRows; row < std::min(rows, (piece + 1) * kRows); ++row)
      mapper.row(static_cast<int>(row), std::span(map.uv).subspan(row * stride, stride));
  });
  return map;
}

struct Remapping {
  Camera source;
  RemapView view;
  ImageMap map;
  double seen_share = 0.0;
  std::vector<RemappedImage> images;
  Diagnostics diagnostics;
};

/// --map and --mask
std::optional<std::string> write_parts(const RemapArguments& arguments, const ImageMap& map,
                                       const std::vector<std::uint8_t>& mask) {
  std::vector<OutputFile> files;
  if (!arguments.map.empty()) files.push_back({arguments.map, npy(map)});
  if (!arguments.mask.empty()) {
    std::optional<std::string> bytes = encoded({map.size.width, map.size.height, 1, Image::Sample::k8Bit, mask}, ".png");
    if (!bytes) return "cannot make " + arguments.mask;
    files.push_back({arguments.mask, *std::move(bytes)});
  }
  return write_files(files, arguments.force, false);
}

std::string view_text(const RemapArguments& arguments, const Remapping& done) {
  const Camera& view = done.view.camera;
  std::string text = done.source.name + ", " + std::string(model_info(done.source.model).id) + ", " +
                     size_in_words(*done.source.image_size) + " px, as " + std::string(model_info(view.model).id) + ", " +
                     size_in_words(*view.image_size) + " px";
  if (!arguments.rotate.empty()) text += ", turned by " + arguments.rotate + " deg (yaw, pitch, roll)";
  return text + "\n" + parameters_in_words(view.model, "  ") + "  the source sees " + percent(done.seen_share) + " of it\n";
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
    if (image.output != "-" && is_told_in_full(done.images.size()))
      text += "wrote " + fca::text::printable(image.output) + "\n";
  }
  const bool interrupted = std::ranges::any_of(done.images, &RemappedImage::left);
  if (!is_told_in_full(done.images.size()) || interrupted) {
    text += std::string(interrupted ? "interrupted: " : "") + std::to_string(written) + " of " +
            std::to_string(done.images.size()) + " images written\n";
  }
  return text;
}

std::string json_of(const RemapArguments& arguments, const Remapping& done, ExitCode code, const Console& console) {
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.put("file", arguments.file);
    json.put("camera", done.source.name);
    json.put("exit_code", static_cast<int>(code));
    json.object("view", [&] {
      json.put("model", model_info(done.view.camera.model).id);
      put_parameters(json, done.view.camera.model);
      json.put("width", done.view.camera.image_size->width);
      json.put("height", done.view.camera.image_size->height);
      json.put("T_source_view", std::span<const double>(done.view.T_source_view.values));
    });
    json.put("seen_share", done.seen_share);
    arguments.map.empty() ? json.null("map") : json.put("map", arguments.map);
    arguments.mask.empty() ? json.null("mask") : json.put("mask", arguments.mask);
    json.array("images", done.images, [&](const RemappedImage& image) {
      json.object([&] {
        json.put("input", image.input);
        is_written(image) ? json.put("output", image.output) : json.null("output");
        put_diagnostics(json, image.diagnostics, console);
      });
    });
    put_diagnostics(json, done.diagnostics, console);
  });
  return json.document();
}

/// Whose images they are, what they are to look like, and the map from the one to the other: into `done`. A code where that
/// cannot be, which is said.
std::optional<ExitCode> make_map(const RemapArguments& arguments, std::span<const FoundFile> images, Console& console,
                                 Remapping& done) {
  const auto refuse = [&] { return console.refuse(worse(code_of(done.diagnostics), ExitCode::kBadInput), done.diagnostics); };
  const std::optional<Camera> source = source_of(arguments, console, done.diagnostics);
  if (!source) return refuse();
  done.source = *source;
  if (images.empty() && !arguments.images.empty())
    return console.refuse(ExitCode::kBadInput, "no image in " + enumerated(arguments.images));
  if (const std::optional<std::string> error = problem_with_output(arguments, images, source->name))
    return console.refuse(ExitCode::kUsage, *error);
  std::optional<RemapView> view = view_of(arguments, *source, console, done.diagnostics);
  if (!view || !sides_are_mapped(*source, done.diagnostics) || !sides_are_mapped(view->camera, done.diagnostics))
    return refuse();
  done.view = *std::move(view);
  const std::optional<ImageMapper> mapper = ImageMapper::between(*source, done.view.camera, done.view.T_source_view,
                                                                 max_angle_rad(arguments.reading), done.diagnostics);
  if (!mapper) return refuse();
  done.map = map_of(*mapper, arguments.jobs);
  return std::nullopt;
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
  const std::string text = (made ? view_text(arguments, done) : "") + images_text(arguments, done);
  arguments.output == "-" ? console.say_aside(text) : console.say(text);
  return code;
}

ExitCode run_remap(const RemapArguments& arguments, Console& console) {
  if (const std::optional<std::string> error = problem_with(arguments)) return console.refuse(ExitCode::kUsage, *error);
  if (const std::optional<std::string> problem = problem_with_patterns(arguments.images))
    return console.refuse(ExitCode::kIo, *problem);
  const std::vector<FoundFile> images =
      arguments.images.empty() ? std::vector<FoundFile>() : walk(arguments.images, &is_image_extension);
  Remapping done;
  if (const std::optional<ExitCode> refused = make_map(arguments, images, console, done)) return *refused;
  const std::vector<std::uint8_t> mask = seen(done.map, *done.source.image_size);
  done.seen_share = static_cast<double>(std::ranges::count(mask, 255)) / static_cast<double>(mask.size());
  if (!(done.seen_share > 0.0))
    return console.refuse(ExitCode::kJudgedBad, done.source.name + " sees nothing of that view; nothing is written");
  console.show(done.diagnostics);
  if (const std::optional<std::string> failure = write_parts(arguments, done.map, mask))
    return console.refuse(ExitCode::kIo, *failure);
  done.images = remap_images(arguments, images, done.source, done.map, console);
  return tell(arguments, done, console);
}

void add_options(CLI::App& command, RemapArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command.add_option("FILE", arguments.file, "Calibration file of the camera that took the images")->required();
  command.add_option("IMAGE", arguments.images, "Images of the calibrated size, folders of them or patterns ('left/*.png')");
  command
      .add_option(
          "-o,--output", arguments.output,
          "An image file, a folder, or a pattern with {stem}, {extension}, {folder}, {camera}; the ending says the format")
      ->type_name("PATH");
  command
      .add_option("--pinhole", arguments.pinhole_deg,
                  "As a pinhole camera: straight lines are straight. Full field of view across the width, in degrees")
      ->type_name("FULL_FOV_DEG")
      ->check(decimal_number());
  command.add_option("--out-size", arguments.out_size, "With --pinhole: size of the image (default: the input's)")
      ->type_name("WxH");
  command.add_option("--model", arguments.model, "As this camera model, fitted as convert does it")->type_name("MODEL");
  command
      .add_option("--like", arguments.like, "As the camera of this calibration file: its only one, or that of the same name")
      ->type_name("FILE");
  command
      .add_option("--rotate", arguments.rotate,
                  "Turn the camera, in degrees: first yaw (about y: positive to the right), then pitch (about its x: positive "
                  "up), then roll (about its z: positive clockwise)")
      ->type_name("YAW,PITCH,ROLL");
  command.add_option("--interpolation", arguments.interpolation, "bilinear (default) or lanczos, as OpenCV does them")
      ->type_name("KIND");
  command.add_option("--mask", arguments.mask, "Also write an image that is 255 where the source sees, and 0 elsewhere")
      ->type_name("PNG");
  command
      .add_option("--map", arguments.map,
                  "Also write the map: float32 of shape (height, width, 2), u and v in the source image, nan where it has "
                  "none; for numpy.load and cv2.remap")
      ->type_name("NPY");
  add_reading_options(command, arguments.reading);
  add_lens_circle_option(command, arguments.reading);
  command.add_option("--jobs", arguments.jobs, "Images at the same time (default: as many as there are processors)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--force", arguments.force, "Overwrite existing files");
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.footer(
      "Axes: x right, y down, z forward; R = Ry(yaw) Rx(pitch) Rz(roll), right-handed, takes the new camera's rays to the old\n"
      "one's. Grey, colour, 16 bits and opacity stay as they are. What the source does not see becomes 0.\n\n"
      "Example:\n"
      "  fca-io remap camchain.yaml --camera cam0 image.png --pinhole 100 -o undistorted.png\n"
      "  fca-io remap camchain.yaml --camera cam0 'left/*.png' --pinhole 90 --rotate 45,0,0 -o 'right/{stem}.png'\n"
      "  fca-io remap camchain.yaml --camera cam0 --model ds --map map.npy --mask seen.png\n");
  command.callback([&arguments, &run] { run = [&arguments](Console& console) { return run_remap(arguments, console); }; });
}

}  // namespace

void add_remap_command(CLI::App& app, RemapArguments& arguments, std::function<ExitCode(Console&)>& run) {
  add_subcommand(app, "remap", "Images as another camera would have taken them: undistorted, as another model, turned",
                 [&arguments, &run](CLI::App& command) { add_options(command, arguments, run); });
}

}  // namespace fca::cli
