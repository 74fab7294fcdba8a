// SPDX-License-Identifier: BSD-3-Clause
#include "reading.h"

#include "words.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/rig/leave_out.h>

#include <algorithm>

#include <CLI/CLI.hpp>

namespace fca::cli {

void add_reading_options(CLI::App& command, ReadingOptions& options) {
  command.add_option("--from", options.from, "The input's format (default: found by its content)")->type_name("FORMAT");
  command
      .add_option("--with", options.with, "A further part of the same calibration, e.g. imu.yaml; may be given several times")
      ->type_name("FILE")
      ->expected(1)
      ->take_all();
  command.add_flag("--join", options.join, "All inputs are the cameras of one rig, in the order given");
  command.add_option("--camera", options.cameras, "Only these cameras, in this order: 1,0 or cam1")->type_name("LIST");
  command.add_option("--size", options.size, "Image size for files that do not state one: 640x480")->type_name("WxH");
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

CLI::Validator decimal_number() {
  const auto problem = [](const std::string& value) {
    return value.empty() || text::parse_real(value) ? std::string() : "'" + value + "' is no decimal number";
  };
  return {problem, ""};
}

namespace {

std::string unknown(std::string_view kind, std::string_view typed, const std::vector<std::string>& names) {
  std::string text = "unknown " + std::string(kind) + " '" + std::string(typed) + "'";
  const std::vector<std::string> near = nearest(typed, names);
  return text + (near.empty() ? "; there are " + enumerated(names) : "; did you mean " + enumerated(near, "or") + "?");
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

std::vector<std::string> format_ids() {
  std::vector<std::string> names;
  for (const Format& format : all_formats()) names.emplace_back(format.id);
  return names;
}

}  // namespace

std::string format_names() { return enumerated(format_ids()); }

std::string unknown_format(std::string_view typed) { return unknown("format", typed, format_ids()); }

std::string unknown_model(std::string_view typed) {
  std::vector<std::string> names;
  for (const ModelInfo& model : all_models()) names.emplace_back(model.id);
  return unknown("camera model", typed, names);
}

std::optional<std::string> check(const ReadingOptions& options) {
  if (!options.from.empty() && find_format(options.from) == nullptr) return unknown_format(options.from);
  if (!options.size.empty() && !parse_size(options.size))
    return "--size wants WIDTHxHEIGHT in whole pixels, such as 640x480; got '" + options.size + "'";
  if (!options.opencv_model.empty() && options.opencv_model != "pinhole" && options.opencv_model != "fisheye")
    return "--opencv-model is pinhole or fisheye, not '" + options.opencv_model + "'";
  if (options.max_angle_deg && !(*options.max_angle_deg > 0.0 && *options.max_angle_deg <= 180.0)) {
    return "--max-angle wants degrees from the axis in (0, 180]";
  }
  return std::nullopt;
}

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
    std::optional<text::Source> source = text::read_source(each, diagnostics);
    if (!source) return std::nullopt;
    console.remember(*source);
    std::optional<text::Document> document = text::parse_document(*std::move(source), diagnostics);
    if (!document) return std::nullopt;
    documents.push_back(*std::move(document));
  }
  const Format* format = options.from.empty() ? nullptr : find_format(options.from);
  std::optional<Calibration> calibration = read_calibration(
      std::move(documents), format, {parse_size(options.size), options.opencv_model, options.join}, diagnostics);
  if (!calibration) return std::nullopt;
  if (const std::optional<ImageSize> size = parse_size(options.size)) {
    for (const Camera& camera : calibration->rig.cameras) {
      if (camera.image_size == size) continue;
      diagnostics.error("size-contradicts",
                        camera.name + " has " + size_in_words(*camera.image_size) + " px in the file, and --size says " +
                            size_in_words(*size),
                        {inputs.front(), 0, 0}, "--size is for files that state no size");
      return std::nullopt;
    }
  }
  if (!options.cameras) return calibration;
  const std::optional<std::vector<std::size_t>> indices = chosen_cameras(calibration->rig, *options.cameras, diagnostics);
  if (!indices) return std::nullopt;
  keep_only(*indices, calibration->rig);
  return calibration;
}

}  // namespace fca::cli
