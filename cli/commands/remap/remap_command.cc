// SPDX-License-Identifier: BSD-3-Clause
#include "remap_command.h"

#include "commands/convert/batch.h"
#include "npy.h"
#include "options/inputs.h"
#include "options/output.h"
#include "options/target.h"
#include "options/words.h"
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
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

namespace fca::cli {

namespace {

/// "yaw,pitch,roll" in degrees.
std::optional<std::string> take_turn(const std::string& word, std::optional<Turn>& target) {
  const std::vector<std::string> words = split(word);
  std::array<double, 3> angles{};
  bool good = words.size() == angles.size();
  for (std::size_t i = 0; good && i < angles.size(); ++i) {
    constexpr double kFullTurn = 360.0;
    const std::optional<double> angle = text::parse_real(words[i]);
    good = angle && std::abs(*angle) <= kFullTurn;
    if (good) angles.at(i) = *angle / kDegreesPerRadian;
  }
  if (!good) return "--rotate wants YAW,PITCH,ROLL in degrees, each from -360 to 360, such as 30,0,0; got '" + word + "'";
  target = Turn{angles[0], angles[1], angles[2]};
  return std::nullopt;
}

/// Takes one of the views, of which one may be given. (The others are told of in usage_error().)
template <class View>
std::optional<std::string> take_view(View view, RemapArguments& arguments) {
  arguments.request.view = std::move(view);
  ++arguments.views;
  return std::nullopt;
}

std::optional<std::string> usage_error(const RemapArguments& arguments) {
  const RemapRequest& request = arguments.request;
  if (const std::optional<std::string> error = problem_with(request.inputs)) return error;
  if (arguments.views > 1)
    return "--model, --like, --pinhole and --equirectangular each say what the image is to look like; give one of them";
  if (arguments.views == 0 && !request.turn) {
    return "say what the image is to look like: --pinhole FULL_FOV_DEG, --equirectangular, --model MODEL, --like FILE or "
           "--rotate YAW,PITCH,ROLL";
  }
  const bool has_own_size =
      std::holds_alternative<PinholeView>(request.view) || std::holds_alternative<EquirectangularView>(request.view);
  if (arguments.view_size && !has_own_size) return "--out-size is for --pinhole and --equirectangular";
  const std::string mask_extension = std::filesystem::path(arguments.mask).extension().string();
  if (!arguments.mask.empty() && mask_extension != ".png") return "--mask wants a .png file";
  if (!arguments.map.empty() && !arguments.map.ends_with(".npy")) return "--map wants a .npy file, which NumPy reads";
  return std::nullopt;
}

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

/// How COLMAP names the camera of such an image.
std::string colmap_line(const ImageSize& size) {
  const std::string numbers = std::to_string(size.width) + " " + std::to_string(size.height);
  return "  in COLMAP's cameras.txt: 1 EQUIRECTANGULAR " + numbers + " " + numbers + "\n";
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
  return text + "\n" + (result.is_equirectangular ? colmap_line(*view.image_size) : parameters_in_words(view.model, "  ")) +
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
  arguments.output.kind == OutputPlace::Kind::kStandardOutput ? console.say_aside(text) : console.say(text);
  return code;
}

ExitCode run_remap(const RemapArguments& arguments, Console& console) {
  if (const std::optional<std::string> error = usage_error(arguments)) return console.refuse(ExitCode::kUsage, *error);
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
    return console.refuse(ExitCode::kJudgedBad, result.source.name + " sees nothing of that view; nothing is written");
  console.show(result.diagnostics);
  if (const std::optional<std::string> failure = write_parts(arguments, result.map, result.mask, console))
    return console.refuse(ExitCode::kIo, *failure);
  done.images = remap_images(arguments, images, result.source, result.map, console);
  return tell(arguments, done, console);
}

void add_options(Options& options, RemapArguments& arguments) {
  RemapRequest& request = arguments.request;
  options.positional("FILE", "Calibration file of the camera that took the images", arguments.file);
  options.positional("IMAGE", "Images of the calibrated size, folders of them or patterns ('left/*.png')", arguments.images,
                     false);
  add_output_option(
      options, "An image file, a folder, or a pattern with {stem}, {extension}, {folder}, {camera}; the ending says the format",
      arguments.output);
  options.group(OptionGroup::kTarget);
  options.number("--pinhole", "FULL_FOV_DEG",
                 "As a pinhole camera: straight lines are straight. Full field of view across the width, in degrees",
                 [&arguments](double degrees) -> std::optional<std::string> {
                   if (!(degrees > 0.0 && degrees < 180.0))
                     return "--pinhole wants the full field of view in degrees, more than 0 and less than 180";
                   return take_view(PinholeView{degrees / kDegreesPerRadian}, arguments);
                 });
  options.flag("--equirectangular",
               "All directions in one image: columns are longitudes, rows latitudes, the axis is in the middle",
               arguments.equirectangular);
  options.value("--out-size", "WxH",
                "Size of the image (default of --pinhole: the input's; of --equirectangular: 2 : 1, as fine as the middle of "
                "the input)",
                [&arguments](const std::string& word) { return take_size("--out-size", word, arguments.view_size); });
  add_model_option(options, {.help = "As this camera model, fitted as convert does it"},
                   [&arguments](const std::string& word) -> std::optional<std::string> {
                     AsModel view;
                     if (std::optional<std::string> problem = take_model(word, view.model)) return problem;
                     return take_view(view, arguments);
                   });
  options.value("--like", "FILE", "As the camera of this calibration file: its only one, or that of the same name",
                [&arguments](const std::string& word) { return take_view(CameraOfFile{word}, arguments); });
  options.value("--rotate", "YAW,PITCH,ROLL",
                "Turn the camera, in degrees: first yaw (about y: positive to the right), then pitch (about its x: positive "
                "up), then roll (about its z: positive clockwise)",
                [&request](const std::string& word) { return take_turn(word, request.turn); });
  options.value("--interpolation", "KIND", "bilinear (default) or lanczos, as OpenCV does them",
                [&arguments](const std::string& word) -> std::optional<std::string> {
                  if (word != "bilinear" && word != "lanczos")
                    return "unknown interpolation '" + word + "'; there are bilinear and lanczos";
                  arguments.interpolation = word == "lanczos" ? Interpolation::kLanczos : Interpolation::kBilinear;
                  return std::nullopt;
                });
  options.group(OptionGroup::kOutput);
  options.value("--mask", "PNG", "Also write an image that is 255 where the source sees, and 0 elsewhere", arguments.mask);
  options.value("--map", "NPY",
                "Also write the map: float32 of shape (height, width, 2), u and v in the source image, nan where it has "
                "none; for numpy.load and cv2.remap",
                arguments.map);
  add_input_options(options, request.inputs);
  add_lens_circle_option(options, request.inputs);
  options.group(OptionGroup::kOutput);
  add_jobs_option(options, "Images at the same time", request.jobs);
  add_force_option(options, "Overwrite existing files", arguments.force);
  add_json_option(options, arguments.json);
  options.footer(
      "Axes: x right, y down, z forward; R = Ry(yaw) Rx(pitch) Rz(roll), right-handed, takes the new camera's rays to the old\n"
      "one's. Grey, colour, 16 bits and opacity stay as they are. What the source does not see becomes 0.\n\n"
      "Example:\n"
      "  fca-io remap camera.yaml image.png --pinhole 100 -o undistorted.png\n"
      "  fca-io remap camera.yaml 'left/*.png' --pinhole 90 --rotate 45,0,0 -o right/\n"
      "  fca-io remap camchain.yaml --camera cam0 --model ds --map map.npy --mask m.png\n");
}

}  // namespace

void add_remap_command(Application& application) {
  application.add("remap", "Images as another camera would have taken them: undistorted, as another model, turned",
                  [](Options& options) -> RunCommand {
                    const auto arguments = std::make_shared<RemapArguments>();
                    add_options(options, *arguments);
                    return [arguments](const TypedOptions&, Console& console) {
                      arguments->request.inputs.files = {arguments->file};
                      if (auto* pinhole = std::get_if<PinholeView>(&arguments->request.view))
                        pinhole->size = arguments->view_size;
                      if (arguments->equirectangular) take_view(EquirectangularView{arguments->view_size}, *arguments);
                      return run_remap(*arguments, console);
                    };
                  });
}

}  // namespace fca::cli
