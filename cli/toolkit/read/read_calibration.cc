// SPDX-License-Identifier: BSD-3-Clause
#include "read/imu_noise.h"
#include "read/lens_circles.h"

#include <fca/code.h>
#include <fca/convert/uncertainty.h>
#include <fca/formats/text/read_document.h>
#include <fca/rig/image_change.h>
#include <fca/rig/remove_frame.h>
#include <fca/toolkit/inputs.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fca {

namespace {

/// Describes the steps of a change: "crop 512 x 512 px at (64, 0)", "binning 2", "resize to 640 x 480 px".
std::vector<Message> steps_of(const ImageChange& change) {
  std::vector<Message> steps;
  if (change.crop)
    steps.push_back({Code::kCropStep, {change.crop->size.width, change.crop->size.height, change.crop->x, change.crop->y}});
  if (change.binning != 1) steps.push_back({Code::kBinningStep, {change.binning}});
  if (change.resize) steps.push_back({Code::kResizeStep, {change.resize->width, change.resize->height}});
  return steps;
}

/// Describes the map of one axis: "u' = 0.5 u - 0.25".
Message in_words(const PixelMap& map, std::size_t axis) {
  const double shift = map.shift.at(axis);
  return {Code::kAxisMap, {axis == 0 ? "u" : "v", map.scale.at(axis), shift < 0.0 ? "-" : "+", std::abs(shift)}};
}

/// Replaces the cameras by the cameras of the changed images. False, with errors, if the change is not possible.
bool change_images(const ImageChange& change, const std::string& input, Rig& rig, Diagnostics& diagnostics) {
  if (change.changes_nothing()) return true;
  if (rig.rectified) diagnostics.add(Code::kRectificationOfOtherImages, {}, {input, 0, 0});
  rig.rectified.reset();
  for (Camera& camera : rig.cameras) {
    Diagnostics found;
    const std::optional<Camera> changed = with_changed_images(camera, change, found);
    for (Diagnostic diagnostic : found.entries()) {
      diagnostic.where = {input, 0, 0};
      diagnostics.add(diagnostic);
    }
    if (!changed) return false;
    const PixelMap map = changed_image(*camera.image_size, change, found)->map;
    const ImageSize& from = *camera.image_size;
    diagnostics.add(Code::kImagesChanged,
                    {camera.name, steps_of(change), from.width, from.height, in_words(map, 0), in_words(map, 1)});
    for (Uncertainty& uncertainty : rig.uncertainties) {
      if (uncertainty.camera == camera.name) uncertainty = with_pixels(uncertainty, camera.model, map);
    }
    camera = *changed;
  }
  return true;
}

/// The indices of the chosen cameras in the rig. nullopt, with an error, if a camera does not exist or is chosen twice.
std::optional<std::vector<std::size_t>> indices_of(const std::vector<CameraChoice>& choices, const Rig& rig,
                                                   Diagnostics& diagnostics) {
  std::vector<std::size_t> indices;
  for (const CameraChoice& choice : choices) {
    const auto by_name = std::ranges::find(rig.cameras, choice.name, &Camera::name);
    auto index = static_cast<std::size_t>(by_name - rig.cameras.begin());
    if (by_name == rig.cameras.end()) index = choice.place.value_or(index);
    if (index >= rig.cameras.size()) {
      std::vector<std::string> names;
      for (const Camera& camera : rig.cameras) names.push_back(camera.name);
      if (names.empty()) names.emplace_back("none");
      diagnostics.add(Code::kUnknownCamera, {choice.name, names});
      return std::nullopt;
    }
    if (std::ranges::find(indices, index) != indices.end()) {
      diagnostics.add(Code::kCameraTwice, {choice.name});
      return std::nullopt;
    }
    indices.push_back(index);
  }
  return indices;
}

/// Keeps only these cameras in the rig, and removes the extra fields, rectification and uncertainties of the others. Poses
/// between the remaining frames that are defined by way of a removed camera are kept.
void keep_only(const std::vector<std::size_t>& indices, Rig& rig) {
  std::vector<Camera> cameras;
  cameras.reserve(indices.size());
  for (const std::size_t index : indices) cameras.push_back(rig.cameras[index]);
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    if (std::ranges::find(indices, i) != indices.end()) continue;
    const std::string& name = rig.cameras[i].name;
    std::erase_if(rig.extra_fields, [&name](const ExtraField& extra) { return extra.owner == name; });
    const auto shows_camera = [&name](const RectifiedPair::View& view) { return view.camera == name; };
    if (rig.rectified && std::ranges::any_of(rig.rectified->views, shows_camera)) rig.rectified.reset();
    std::erase_if(rig.uncertainties, [&name](const Uncertainty& each) { return each.camera == name; });
    std::erase_if(rig.pose_uncertainties, [&name](const PoseUncertainty& each) { return each.a == name || each.b == name; });
    remove_frame(name, rig);
  }
  rig.cameras = std::move(cameras);
}

/// Reads the files to which the last document refers as its parts, and appends them to `documents`. `format`: the format of the
/// last document. A missing part is a warning, since the user may only need the contents of the others; then no part is
/// appended. False, with errors, if a part cannot be parsed.
bool add_parts(const Format& format, Files& files, std::vector<text::Document>& documents, Diagnostics& diagnostics) {
  std::vector<text::Document> parts;
  bool all_found = true;
  for (const NamedFile& named : named_parts(format, documents.back())) {
    std::optional<text::Source> source = read_part(named);
    if (!source) {
      diagnostics.add(Code::kPartMissing, {named.path}, named.where);
      all_found = false;
      continue;
    }
    files.remember(*source);
    std::optional<text::Document> part = files.parse(*std::move(source), diagnostics);
    if (!part) return false;
    parts.push_back(*std::move(part));
  }
  if (all_found) std::ranges::move(parts, std::back_inserter(documents));
  return true;
}

/// The request can give an image size for files without a size. False, with an error, if a file contains another image size.
bool has_given_size(const Inputs& inputs, const Calibration& calibration, Diagnostics& diagnostics) {
  const std::optional<ImageSize>& size = inputs.image_size;
  if (!size) return true;
  // If one of several cameras has the given size, the others may have their own.
  const bool one_camera_has_it =
      std::ranges::find(calibration.rig.cameras, size, &Camera::image_size) != calibration.rig.cameras.end();
  for (const Camera& camera : calibration.rig.cameras) {
    if (camera.image_size == size || one_camera_has_it) continue;
    diagnostics.add(Code::kGivenSizeContradicts,
                    {camera.name, camera.image_size->width, camera.image_size->height, size->width, size->height},
                    {inputs.files.front(), 0, 0});
    return false;
  }
  return true;
}

/// False, with an error, if the request gives a length unit although all files contain their own.
bool has_use_for_unit(const Inputs& inputs, const Calibration& calibration, Diagnostics& diagnostics) {
  if (!inputs.length_unit_m || calibration.poses_in_told_unit > 0) return true;
  diagnostics.add(Code::kUnitWithoutUse, {calibration.format->title}, {inputs.files.front(), 0, 0});
  return false;
}

/// Replaces each folder that contains one rig or a COLMAP model by its files.
Inputs with_rig_files(const Inputs& inputs) {
  Inputs result = inputs;
  result.files.clear();
  for (const std::string& path : inputs.files) {
    const std::vector<std::string> files = rig_files_in(path);
    if (const std::vector<std::string> model = model_files_in(path); !model.empty()) {
      result.files.push_back(model.front());
      result.parts.insert(result.parts.begin(), model.begin() + 1, model.end());
      continue;
    }
    result.join = result.join || !files.empty();
    result.files.insert(result.files.end(), files.begin(), files.end());
    if (files.empty()) result.files.push_back(cameras_file_in(path).value_or(path));
  }
  return result;
}

/// True if the format's reader has already converted such noise to densities.
bool is_converted(NoiseKind kind, const Format& format) { return format.noise_of_samples && kind == NoiseKind::kDiscrete; }

}  // namespace

std::optional<Calibration> read_models(const Inputs& inputs, Files& files, Diagnostics& diagnostics) {
  std::optional<Calibration> calibration = read_calibration(inputs, files, diagnostics);
  if (!calibration) return std::nullopt;
  for (const Camera& camera : calibration->rig.cameras) {
    if (!camera.rays.empty()) diagnostics.add(Code::kOnlyRaysKnown, {camera.name}, {inputs.files.front(), 0, 0});
  }
  return diagnostics.has_errors() ? std::nullopt : std::move(calibration);
}

std::optional<Calibration> read_as_stated(const Inputs& given, Files& files, Diagnostics& diagnostics) {
  if (given.files.empty()) {
    diagnostics.add(Code::kNoInput);
    return std::nullopt;
  }
  const Inputs inputs = with_rig_files(given);
  std::vector<std::string> paths = inputs.files;
  paths.insert(paths.end(), inputs.parts.begin(), inputs.parts.end());
  std::vector<text::Document> documents;
  std::vector<std::optional<DetectedFormat>> detected;
  for (const std::string& path : paths) {
    std::optional<text::Source> source = files.read(path, diagnostics);
    if (!source) return std::nullopt;
    std::optional<text::Document> document = files.parse(*std::move(source), diagnostics);
    if (!document) return std::nullopt;
    documents.push_back(*std::move(document));
    detected.resize(documents.size());
    Diagnostics discarded;
    if (inputs.format == nullptr) detected.back() = detect_format(documents.back(), discarded);
    const Format* format = detected.back() ? detected.back()->format : inputs.format;
    if (format != nullptr && !add_parts(*format, files, documents, diagnostics)) return std::nullopt;
  }
  std::optional<Calibration> calibration =
      read_calibration(std::move(documents), inputs.format, read_options(inputs), diagnostics, detected);
  if (!calibration || !has_given_size(inputs, *calibration, diagnostics) ||
      !has_use_for_unit(inputs, *calibration, diagnostics))
    return std::nullopt;
  return calibration;
}

bool apply_choices(const Inputs& inputs, Files& files, Calibration& calibration, Diagnostics& diagnostics) {
  if (inputs.cameras) {
    const std::optional<std::vector<std::size_t>> indices = indices_of(*inputs.cameras, calibration.rig, diagnostics);
    if (!indices) return false;
    keep_only(*indices, calibration.rig);
  }
  if (!add_lens_circles(inputs.lens_circles, inputs.change, files, calibration.rig, diagnostics)) return false;
  const std::string& input = inputs.files.front();
  return change_images(inputs.change, input, calibration.rig, diagnostics) &&
         (!inputs.imu_rate_hz || set_imu_rate(*inputs.imu_rate_hz, input, calibration.rig, diagnostics)) &&
         (!inputs.imu_noise || is_converted(*inputs.imu_noise, *calibration.format) ||
          make_densities(*inputs.imu_noise, input, calibration.rig, diagnostics));
}

std::optional<Calibration> read_calibration(const Inputs& inputs, Files& files, Diagnostics& diagnostics) {
  std::optional<Calibration> calibration = read_as_stated(inputs, files, diagnostics);
  if (!calibration || !apply_choices(inputs, files, *calibration, diagnostics)) return std::nullopt;
  return calibration;
}

ReadOptions read_options(const Inputs& inputs) {
  return {inputs.image_size, inputs.opencv_model, inputs.join, inputs.length_unit_m, inputs.imu_rate_hz};
}

}  // namespace fca
