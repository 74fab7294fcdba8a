// SPDX-License-Identifier: BSD-3-Clause
#include "rectify.h"

#include "inputs.h"
#include "output.h"
#include "remap.h"
#include "shell/words.h"
#include "target.h"
#include "words.h"

#include <fca/formats/text/prose.h>

#include <filesystem>
#include <map>
#include <memory>
#include <variant>

namespace fca::cli {

namespace {

/// --to's words, of a request that knows programs' names.
void take_over(const ConvertRequest& target, RectifyRequest& request) {
  request.to = target.to;
  request.layout = target.layout;
  request.extension = target.extension;
}

std::optional<std::string> take_view(RectifiedViewChoice view, RectifyRequest& request) {
  if (!std::holds_alternative<std::monostate>(request.view))
    return "--pinhole and --alpha both set the width of the rectified view; give one of them";
  request.view = view;
  return std::nullopt;
}

std::optional<std::string> take_map_format(const std::string& word, RectifyArguments& arguments) {
  const std::map<std::string, MapFormat> known = {
      {"npy", MapFormat::kNpy}, {"float", MapFormat::kFloat}, {"fixed", MapFormat::kFixedPoint}};
  const auto found = known.find(word);
  if (found == known.end()) return "--map-format is npy, float or fixed, not '" + word + "'";
  arguments.maps = true;
  arguments.map_format = found->second;
  return std::nullopt;
}

void add_view_options(Options& options, RectifyArguments& arguments) {
  RectifyRequest& request = arguments.request;
  options.group(OptionGroup::kTarget);
  options.number("--pinhole", "FULL_FOV_DEG",
                 "Full field of view across the width of the rectified images, in degrees, up to 120",
                 [&request](double degrees) -> std::optional<std::string> {
                   if (!(degrees > 0.0 && degrees < 180.0))
                     return "--pinhole wants the full field of view in degrees, more than 0 and less than 180";
                   return take_view(RectifiedByField{degrees / kDegreesPerRadian}, request);
                 });
  options.number("--alpha", "A",
                 "As in OpenCV: with 0, every rectified pixel is seen by its camera; with 1, the images show all that the "
                 "cameras see. (Default: the file's rectification; else 0, or for lenses of 120 deg and more a view as fine as "
                 "the middle of the images)",
                 [&request](double alpha) -> std::optional<std::string> {
                   if (!(alpha >= 0.0 && alpha <= 1.0)) return "--alpha wants a number from 0 to 1";
                   return take_view(RectifiedByAlpha{alpha}, request);
                 });
  options.value("--out-size", "WxH", "Size of the rectified images (default: the cameras')",
                [&request](const std::string& word) { return take_size("--out-size", word, request.size); });
  options.flag("--like-opencv",
               "Use OpenCV's stereoRectify or fisheye::stereoRectify, and print how far fca-io's own rectification is from it",
               arguments.like_opencv);
  options.flag("--maps",
               "Also write left_map.npy and right_map.npy: float32 of shape (height, width, 2), u and v in the camera's image, "
               "nan where it has none; for numpy.load and cv2.remap",
               arguments.maps);
  options.value("--map-format", "npy|float|fixed",
                "Write maps as npy (the default), or as map1 and map2 for cv::FileStorage and cv::remap: float (CV_32FC1) or "
                "fixed (CV_16SC2 and CV_16UC1), in left_map.yml, or left_map.yml.gz above a million pixels",
                [&arguments](const std::string& word) { return take_map_format(word, arguments); });
  add_interpolation_option(options, arguments.interpolation);
}

std::optional<std::string> finish(RectifyArguments& arguments) {
  RectifyRequest& request = arguments.request;
  const OutputPlace& output = arguments.output;
  const bool images = !arguments.left.empty();
  if (images && arguments.right.empty()) return "give the images of both cameras: LEFT and RIGHT";
  if (arguments.like_opencv && std::holds_alternative<RectifiedByField>(request.view))
    return "OpenCV takes no field of view: --like-opencv goes with --alpha";
  const bool needs_folder = images || arguments.maps;
  if (needs_folder && output.kind != OutputPlace::Kind::kFolder) return "images and maps need a folder: -o FOLDER/";
  if (output.kind == OutputPlace::Kind::kPattern) return "-o names a file or a folder here";
  if (output.is_said() && !needs_folder && request.to == nullptr)
    return "there is nothing to write: give --to FORMAT, --maps, or the images LEFT and RIGHT";
  const std::string extension = std::filesystem::path(output.path).extension().string();
  if (output.kind == OutputPlace::Kind::kFile && !extension.empty()) request.extension = extension;
  request.maps = needs_folder;
  return std::nullopt;
}

}  // namespace

void add_rectify_options(Options& options, RectifyArguments& arguments) {
  RectifyRequest& request = arguments.request;
  options.one_positional("FILE", "Calibration file of the stereo pair", request.inputs.files);
  options.one_positional("LEFT", "Images of the left (upper) camera: a file, a folder or a pattern", arguments.left, false);
  options.one_positional("RIGHT", "Images of the right (lower) camera", arguments.right, false);
  add_output_option(options,
                    "A folder for the settings, the maps, and the images (in left/ and right/, under their own names); or a "
                    "file for settings alone (default: standard output)",
                    arguments.output);
  options.group(OptionGroup::kTarget);
  const auto target = std::make_shared<ConvertRequest>();
  options.value("--to", "FORMAT",
                "Write settings: orbslam3 (for rectified images), orbslam2 (with LEFT.* and RIGHT.*), ros (R and P of both "
                "cameras) or opencv (R1 R2 P1 P2 Q)",
                [&request, target](const std::string& word) {
                  const std::optional<std::string> problem = take_target(word, *target);
                  take_over(*target, request);
                  return problem;
                });
  add_view_options(options, arguments);
  add_input_options(options, request.inputs);
  add_lens_circle_option(options, request.inputs);
  add_join_option(options, request.inputs);
  add_jobs_option(options, "Images rectified at the same time", request.jobs);
  add_force_option(options, "Overwrite existing files", arguments.force);
  add_json_option(options, arguments.json);
  options.footer(
      "fca-io finds by the geometry which camera is the left one.\n\n"
      "Example:\n"
      "  fca-io rectify camchain.yaml --with imu.yaml --to orbslam3 -o settings.yaml\n"
      "  fca-io rectify stereo.yml left/ right/ --maps -o rectified/\n");
  options.afterwards([&arguments] { return finish(arguments); });
}

}  // namespace fca::cli
