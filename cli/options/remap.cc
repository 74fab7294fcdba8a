// SPDX-License-Identifier: BSD-3-Clause
#include "remap.h"

#include "inputs.h"
#include "output.h"
#include "shell/words.h"
#include "target.h"
#include "words.h"

#include <fca/formats/text/numbers.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <variant>

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
  if (!good) return "--rotate takes YAW,PITCH,ROLL in degrees, each from -360 to 360, such as 30,0,0; got '" + word + "'";
  target = Turn{angles[0], angles[1], angles[2]};
  return std::nullopt;
}

std::optional<std::string> take_interpolation(const std::string& word, Interpolation& target) {
  if (word != "bilinear" && word != "lanczos") return "unknown interpolation '" + word + "'; there are bilinear and lanczos";
  target = word == "lanczos" ? Interpolation::kLanczos : Interpolation::kBilinear;
  return std::nullopt;
}

/// What was typed of the view, before all words together make one of it.
struct TypedView {
  int count = 0;  ///< How many views were given; one is allowed.
  bool equirectangular = false;
  std::optional<ImageSize> size;  ///< --out-size
};

/// Takes one of the views. (finish_view() refuses several.)
std::optional<std::string> take_view(ViewCamera view, RemapRequest& request, TypedView& typed) {
  request.view = std::move(view);
  ++typed.count;
  return std::nullopt;
}

std::optional<std::string> finish_view(RemapRequest& request, TypedView& typed) {
  auto* const pinhole = std::get_if<PinholeView>(&request.view);
  if (pinhole != nullptr) pinhole->size = typed.size;
  if (typed.equirectangular) static_cast<void>(take_view(EquirectangularView{typed.size}, request, typed));
  if (typed.count > 1) return "--model, --like, --pinhole and --equirectangular each choose the new camera; give one of them";
  if (typed.count == 0 && !request.turn) {
    return "choose the new camera: --pinhole FULL_FOV_DEG, --equirectangular, --model MODEL, --like FILE or --rotate "
           "YAW,PITCH,ROLL";
  }
  if (typed.size && pinhole == nullptr && !typed.equirectangular) return "--out-size is for --pinhole and --equirectangular";
  return std::nullopt;
}

std::optional<std::string> problem_with_extensions(const RemapArguments& arguments) {
  const std::string mask_extension = std::filesystem::path(arguments.mask).extension().string();
  if (!arguments.mask.empty() && mask_extension != ".png") return "--mask wants a .png file";
  if (!arguments.map.empty() && !arguments.map.ends_with(".npy")) return "--map wants a .npy file, which NumPy reads";
  return std::nullopt;
}

/// Nothing to write, or no place for it.
std::optional<std::string> problem_with_outputs(const RemapArguments& arguments) {
  constexpr std::array<std::string_view, 4> kOfImages = {"{stem}", "{extension}", "{folder}", "{camera}"};
  const OutputPlace& output = arguments.output;
  if (arguments.images.empty() && arguments.map.empty() && arguments.mask.empty())
    return "give images to remap, or --map or --mask to write those alone";
  if (arguments.images.empty() && output.is_said()) return "-o is for images, but you gave none";
  if (!arguments.images.empty() && !output.is_said())
    return "-o is missing: a file, a folder, or a pattern such as 'out/{stem}.png'";
  if (arguments.json && output.kind == OutputPlace::Kind::kStandardOutput) return "with --json the image needs a file: -o PATH";
  if (!arguments.map.empty() && arguments.map == arguments.mask) return "--map and --mask name the same file";
  return problem_with_pattern(output, kOfImages);
}

void add_view_options(Options& options, RemapArguments& arguments, const std::shared_ptr<TypedView>& typed) {
  RemapRequest& request = arguments.request;
  options.group(OptionGroup::kTarget);
  options.number("--pinhole", "FULL_FOV_DEG",
                 "As a pinhole camera: straight lines are straight. Full field of view across the width, in degrees",
                 [&request, typed](double degrees) -> std::optional<std::string> {
                   if (!(degrees > 0.0 && degrees < 180.0))
                     return "--pinhole wants the full field of view in degrees, more than 0 and less than 180";
                   return take_view(PinholeView{degrees / kDegreesPerRadian}, request, *typed);
                 });
  options.flag("--equirectangular",
               "All directions in one image: columns are longitudes, rows latitudes, the axis is in the middle",
               typed->equirectangular);
  options.value("--out-size", "WxH",
                "Size of the image (default of --pinhole: the input's; of --equirectangular: 2 : 1, as fine as the middle of "
                "the input)",
                [typed](const std::string& word) { return take_size("--out-size", word, typed->size); });
  add_model_option(options, {.help = "As this camera model, fitted as convert does it"},
                   [&request, typed](const std::string& word) -> std::optional<std::string> {
                     AsModel view;
                     if (std::optional<std::string> problem = take_model(word, view.model)) return problem;
                     return take_view(view, request, *typed);
                   });
  options.value("--like", "FILE",
                "As the camera of this calibration file: its only camera, or the one with the same name; for a ROS "
                "camera_info, as the image that image_proc rectifies with R and P",
                [&request, typed](const std::string& word) { return take_view(CameraOfFile{word}, request, *typed); });
  options.value("--rotate", "YAW,PITCH,ROLL",
                "Turn the camera, in degrees: first yaw (about y: positive to the right), then pitch (about its x: positive "
                "up), then roll (about its z: positive clockwise)",
                [&request](const std::string& word) { return take_turn(word, request.turn); });
  add_interpolation_option(options, arguments.interpolation);
}

}  // namespace

void add_interpolation_option(Options& options, Interpolation& target) {
  options.value("--interpolation", "KIND", "bilinear (default) or lanczos, as OpenCV does them",
                [&target](const std::string& word) { return take_interpolation(word, target); });
}

void add_remap_options(Options& options, RemapArguments& arguments) {
  RemapRequest& request = arguments.request;
  options.one_positional("FILE", "Calibration file of the camera that took the images", request.inputs.files);
  options.positional("IMAGE", "Images of the calibrated size, folders of them or patterns ('left/*.png')", arguments.images,
                     false);
  add_output_option(
      options,
      "An image file, a folder, or a pattern with {stem}, {extension}, {folder}, {camera}; the extension sets the format",
      arguments.output);
  const auto typed = std::make_shared<TypedView>();
  add_view_options(options, arguments, typed);
  options.group(OptionGroup::kOutput);
  options.value("--mask", "PNG", "Also write an image that is 255 where the source camera sees, and 0 elsewhere",
                arguments.mask);
  options.value("--map", "NPY",
                "Also write the map: float32 of shape (height, width, 2), u and v in the source image, nan where it has "
                "none; for numpy.load and cv2.remap",
                arguments.map);
  add_input_options(options, request.inputs);
  add_lens_circle_option(options, request.inputs);
  add_jobs_option(options, "Images remapped at the same time", request.jobs);
  add_force_option(options, "Overwrite existing files", arguments.force);
  add_json_option(options, arguments.json);
  options.footer(
      "Axes: x right, y down, z forward; R = Ry(yaw) Rx(pitch) Rz(roll), right-handed, takes the new camera's rays to the "
      "old one's. Grey, colour, 16 bits and opacity stay as they are. Pixels that the source does not see become 0.\n\n"
      "Example:\n"
      "  fca-io remap camera.yaml image.png --pinhole 100 -o undistorted.png\n"
      "  fca-io remap camera.yaml 'left/*.png' --pinhole 90 --rotate 45,0,0 -o right/\n"
      "  fca-io remap camchain.yaml --camera cam0 --model ds --map map.npy --mask m.png\n");
  options.afterwards([&request, typed] { return finish_view(request, *typed); });
  options.afterwards([&arguments] { return problem_with_extensions(arguments); });
  options.afterwards([&arguments] { return problem_with_outputs(arguments); });
}

}  // namespace fca::cli
