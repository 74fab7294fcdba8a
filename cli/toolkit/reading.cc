// SPDX-License-Identifier: BSD-3-Clause
#include "reading.h"

#include "imu_noise.h"
#include "lens_circles.h"
#include "shell/words.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/rig/image_change.h>
#include <fca/rig/leave_out.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include <CLI/CLI.hpp>

namespace fca::cli {

void add_reading_options(CLI::App& command, ReadingOptions& options) {
  command.add_option("--from", options.from, "The input's format (default: found by its content)")->type_name("FORMAT");
  take_one_each_time(*command
                          .add_option("--with", options.with,
                                      "A further part of the same calibration, e.g. imu.yaml; may be given several times")
                          ->type_name("FILE"));
  command.add_option("--camera", options.cameras, "Only these cameras, in this order: 1,0 or cam1")->type_name("LIST");
  command.add_option("--size", options.size, "Image size of an input that does not state one: 640x480")->type_name("WxH");
  command.add_option("--crop", options.crop, "The images are this part of the calibrated ones; before --binning and --resize")
      ->type_name("X,Y,W,H");
  command.add_option("--binning", options.binning, "N x N pixels of the calibrated images are one; before --resize")
      ->type_name("N")
      ->check(decimal_number());
  command.add_option("--resize", options.resize, "The images are the calibrated ones, scaled to this size")->type_name("WxH");
  command
      .add_option("--opencv-model", options.opencv_model,
                  "pinhole or fisheye, for OpenCV files whose four coefficients could be either")
      ->type_name("MODEL");
  command
      .add_option("--max-angle", options.max_angle_deg,
                  "What counts as lens, in degrees from the axis (default: the whole image)")
      ->type_name("DEG")
      ->check(decimal_number());
}

void add_lens_circle_option(CLI::App& command, ReadingOptions& options) {
  take_one_each_time(*command
                          .add_option("--lens-circle", options.lens_circles,
                                      "What counts as lens: the lit circle in this image, taken by the camera (of several: "
                                      "cam0=IMAGE); may be given several times, for dark scenes")
                          ->type_name("[CAMERA=]IMAGE"));
}

void add_join_option(CLI::App& command, ReadingOptions& options) {
  command.add_flag("--join", options.join, "All inputs are the cameras of one rig, in the order given");
}

void add_imu_option(CLI::App& command, ReadingOptions& options) {
  command
      .add_option("--imu-noise", options.imu_noise,
                  "What the input's IMU noise is: continuous (densities, the default), discrete (standard deviations of single "
                  "samples, converted with the rate), variance or discrete-variance (squares of those)")
      ->type_name("KIND");
}

void take_one_each_time(CLI::Option& option) { option.expected(1)->allow_extra_args(false)->take_all(); }

CLI::Validator decimal_number() {
  const auto problem = [](const std::string& value) {
    return value.empty() || text::parse_real(value) ? std::string() : "'" + value + "' is no decimal number";
  };
  return {problem, ""};
}

namespace {

/// "64,0,512,512"
std::optional<ImageRegion> parse_region(const std::string& text) {
  std::vector<int> numbers;
  for (const std::string& item : CLI::detail::split(text, ',')) {
    const std::optional<int> number = text::parse_int(item);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != 4) return std::nullopt;
  return ImageRegion{numbers[0], numbers[1], {numbers[2], numbers[3]}};
}

/// "crop 512 x 512 px at (64, 0), binning 2, resize to 640 x 480 px"
std::string in_words(const ImageChange& change) {
  std::vector<std::string> steps;
  if (change.crop) {
    steps.push_back("crop " + size_in_words(change.crop->size) + " px at (" + std::to_string(change.crop->x) + ", " +
                    std::to_string(change.crop->y) + ")");
  }
  if (change.binning != 1) steps.push_back("binning " + std::to_string(change.binning));
  if (change.resize) steps.push_back("resize to " + size_in_words(*change.resize) + " px");
  return enumerated(steps, "then");
}

/// "u' = 0.5 u - 0.25"
std::string in_words(const PixelMap& map, std::size_t axis) {
  const std::string name = axis == 0 ? "u" : "v";
  const double shift = map.shift.at(axis);
  return name + "' = " + text::format_short(map.scale.at(axis)) + " " + name + (shift < 0.0 ? " - " : " + ") +
         text::format_short(std::abs(shift));
}

ImageChange image_change(const ReadingOptions& options) {
  return {options.crop.empty() ? std::nullopt : parse_region(options.crop), options.binning, parse_size(options.resize)};
}

/// The cameras of the images that were made from the calibrated ones, as the options say.
bool change_images(const ReadingOptions& options, const std::string& input, Rig& rig, Diagnostics& diagnostics) {
  const ImageChange change = image_change(options);
  if (change.changes_nothing()) return true;
  for (Camera& camera : rig.cameras) {
    Diagnostics found;
    const std::optional<Camera> changed = with_changed_images(camera, change, found);
    for (Diagnostic diagnostic : found.entries()) {
      diagnostic.where = {input, 0, 0};
      diagnostics.add(diagnostic);
    }
    if (!changed) return false;
    const PixelMap map = changed_image(*camera.image_size, change, found)->map;
    diagnostics.note("images-changed", camera.name + ": " + in_words(change) + ", from " + size_in_words(*camera.image_size) +
                                           " px: " + in_words(map, 0) + ", " + in_words(map, 1));
    camera = *changed;
  }
  return true;
}

/// "1,0" or "cam1,cam0" -> indices into the rig; nothing with an error for one that is not there.
std::optional<std::vector<std::size_t>> chosen_cameras(const Rig& rig, const std::string& list, Diagnostics& diagnostics) {
  std::vector<std::size_t> indices;
  for (const std::string& item : CLI::detail::split(list, ',')) {
    const auto by_name = std::ranges::find(rig.cameras, item, &Camera::name);
    std::size_t index = static_cast<std::size_t>(by_name - rig.cameras.begin());
    if (const std::optional<int> number = text::parse_int(item); by_name == rig.cameras.end() && number && *number >= 0) {
      index = static_cast<std::size_t>(*number);
    }
    if (index >= rig.cameras.size()) {
      std::vector<std::string> names;
      for (const Camera& camera : rig.cameras) names.push_back(camera.name);
      diagnostics.error("unknown-camera", "there is no camera '" + item + "'; the calibration has " +
                                              (names.empty() ? "none" : enumerated(names)));
      return std::nullopt;
    }
    if (std::ranges::find(indices, index) != indices.end()) {
      diagnostics.error("unknown-camera", "camera '" + item + "' is chosen twice");
      return std::nullopt;
    }
    indices.push_back(index);
  }
  return indices;
}

/// The rig with these cameras alone. What only one left out says is not asked for, either; poses by way of it stay.
void keep_only(const std::vector<std::size_t>& indices, Rig& rig) {
  std::vector<Camera> cameras;
  cameras.reserve(indices.size());
  for (const std::size_t index : indices) cameras.push_back(rig.cameras[index]);
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    if (std::ranges::find(indices, i) != indices.end()) continue;
    const std::string& name = rig.cameras[i].name;
    std::erase_if(rig.as_read, [&name](const AsRead& extra) { return extra.key.starts_with(name + " "); });
    leave_out(name, rig);
  }
  rig.cameras = std::move(cameras);
}

/// Standard input can be read once; who asks for it again (a report shows, checks and converts) gets what was read.
std::optional<text::Source> read_once(const std::string& path, const Console& console, Diagnostics& diagnostics) {
  const auto& read = console.sources();
  const auto found = path == "-" ? std::ranges::find(read, text::kStandardInput, &text::Source::name) : read.end();
  return found != read.end() ? std::optional(*found) : text::read_source(path, diagnostics);
}

std::vector<std::string> format_ids() {
  std::vector<std::string> names;
  for (const Format& format : all_formats()) names.emplace_back(format.id);
  return names;
}

/// Reads the files that the last of the documents names as parts of it. One that is not there is a warning: what the others say
/// may be all that is wanted. False with errors.
bool add_parts(const ReadingOptions& options, Console& console, std::vector<text::Document>& documents,
               Diagnostics& diagnostics) {
  Diagnostics told_later;
  const std::optional<DetectedFormat> detected =
      options.from.empty() ? detect_format(documents.back(), told_later) : DetectedFormat{find_format(options.from), ""};
  if (!detected) return true;
  std::vector<text::Document> parts;
  bool all_there = true;
  for (const NamedFile& named : named_parts(*detected->format, documents.back())) {
    std::optional<text::Source> source = read_part(named);
    if (!source) {
      diagnostics.warning("part-missing", "it names " + named.path + ", which cannot be read: its cameras are not known",
                          named.where, "put that file there; --into needs it only for cameras that stay");
      all_there = false;
      continue;
    }
    console.remember(*source);
    std::optional<text::Document> part = text::parse_document(*std::move(source), diagnostics);
    if (!part) return false;
    parts.push_back(*std::move(part));
  }
  if (all_there) std::ranges::move(parts, std::back_inserter(documents));
  return true;
}

}  // namespace

std::string format_names() { return enumerated(format_ids()); }

std::string unknown_format(std::string_view typed) { return unknown_word("format", typed, format_ids()); }

std::string unknown_model(std::string_view typed) {
  std::vector<std::string> names;
  for (const ModelInfo& model : all_models()) names.emplace_back(model.id);
  return unknown_word("camera model", typed, names);
}

std::optional<std::string> check(const ReadingOptions& options) {
  if (!options.from.empty() && find_format(options.from) == nullptr) return unknown_format(options.from);
  if (!options.size.empty() && !parse_size(options.size))
    return "--size wants WIDTHxHEIGHT in whole pixels, such as 640x480; got '" + options.size + "'";
  if (!options.crop.empty() && !parse_region(options.crop))
    return "--crop wants X,Y,WIDTH,HEIGHT in whole pixels, such as 64,0,512,512; got '" + options.crop + "'";
  if (options.binning < 1) return "--binning wants a whole number from 1";
  if (!options.resize.empty() && !parse_size(options.resize))
    return "--resize wants WIDTHxHEIGHT in whole pixels, such as 640x480; got '" + options.resize + "'";
  if (!options.opencv_model.empty() && options.opencv_model != "pinhole" && options.opencv_model != "fisheye")
    return "--opencv-model is pinhole or fisheye, not '" + options.opencv_model + "'";
  if (!options.imu_noise.empty() && find_noise_kind(options.imu_noise) == nullptr)
    return "--imu-noise is continuous, discrete, variance or discrete-variance, not '" + options.imu_noise + "'";
  if (options.max_angle_deg && !(*options.max_angle_deg > 0.0 && *options.max_angle_deg <= 180.0)) {
    return "--max-angle wants degrees from the axis in (0, 180]";
  }
  if (options.max_angle_deg && !options.lens_circles.empty())
    return "--max-angle and --lens-circle both say where the lens ends; give one of them";
  return std::nullopt;
}

bool changes_images(const ReadingOptions& options) { return !image_change(options).changes_nothing(); }

std::optional<double> max_angle_rad(const ReadingOptions& options) {
  if (!options.max_angle_deg) return std::nullopt;
  return *options.max_angle_deg / kDegreesPerRadian;
}

std::vector<std::vector<std::string>> grouped(const std::vector<std::string>& inputs, const ReadingOptions& options) {
  if (options.join) return {inputs};
  std::vector<std::vector<std::string>> groups;
  groups.reserve(inputs.size());
  for (const std::string& input : inputs) groups.push_back({input});
  return groups;
}

std::optional<Calibration> read_input(const std::string& path, const ReadingOptions& options, Console& console,
                                      Diagnostics& diagnostics) {
  return read_input(std::span(&path, 1), options, console, diagnostics);
}

std::optional<Calibration> read_input(std::span<const std::string> inputs, const ReadingOptions& options, Console& console,
                                      Diagnostics& diagnostics) {
  std::vector<std::string> paths(inputs.begin(), inputs.end());
  paths.insert(paths.end(), options.with.begin(), options.with.end());
  std::vector<text::Document> documents;
  for (const std::string& each : paths) {
    std::optional<text::Source> source = read_once(each, console, diagnostics);
    if (!source) return std::nullopt;
    console.remember(*source);
    std::optional<text::Document> document = text::parse_document(*std::move(source), diagnostics);
    if (!document) return std::nullopt;
    documents.push_back(*std::move(document));
    if (!add_parts(options, console, documents, diagnostics)) return std::nullopt;
  }
  const Format* format = options.from.empty() ? nullptr : find_format(options.from);
  std::optional<Calibration> calibration = read_calibration(
      std::move(documents), format, {parse_size(options.size), options.opencv_model, options.join}, diagnostics);
  if (!calibration) return std::nullopt;
  if (const std::optional<ImageSize> size = parse_size(options.size)) {
    // Of several files those that state a size may state another one.
    const bool of_one_of_many = options.join && std::ranges::find(calibration->rig.cameras, size, &Camera::image_size) !=
                                                    calibration->rig.cameras.end();
    for (const Camera& camera : calibration->rig.cameras) {
      if (camera.image_size == size || of_one_of_many) continue;
      diagnostics.error("size-contradicts",
                        camera.name + " has " + size_in_words(*camera.image_size) + " px in the file, and --size says " +
                            size_in_words(*size),
                        {inputs.front(), 0, 0}, "--size is for files that state no size");
      return std::nullopt;
    }
  }
  if (options.cameras) {
    const std::optional<std::vector<std::size_t>> indices = chosen_cameras(calibration->rig, *options.cameras, diagnostics);
    if (!indices) return std::nullopt;
    keep_only(*indices, calibration->rig);
  }
  if (!add_lens_circles(options.lens_circles, image_change(options), calibration->rig, diagnostics)) return std::nullopt;
  if (!change_images(options, inputs.front(), calibration->rig, diagnostics)) return std::nullopt;
  const NoiseKind* noise = find_noise_kind(options.imu_noise);
  if (noise != nullptr && !make_densities(*noise, inputs.front(), calibration->rig, diagnostics)) return std::nullopt;
  return calibration;
}

}  // namespace fca::cli
