// SPDX-License-Identifier: BSD-3-Clause
#include "remap/compute_map.h"

#include <fca/code.h>
#include <fca/convert/convert.h>
#include <fca/formats/rectified_image.h>
#include <fca/remap/view.h>
#include <fca/toolkit/remap.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca {

namespace {

/// Reads the camera whose images are remapped. nullopt, with an error, if there is no camera, more than one, or no image size.
std::optional<Camera> source_of(const RemapRequest& request, Files& files, Diagnostics& diagnostics) {
  const std::optional<Calibration> calibration = read_models(request.inputs, files, diagnostics);
  if (!calibration) return std::nullopt;
  const std::vector<Camera>& cameras = calibration->rig.cameras;
  const auto refuse = [&](Code code) {
    diagnostics.add(code, {cameras.size()}, {request.inputs.files.front(), 0, 0});
    return std::nullopt;
  };
  if (cameras.empty()) return refuse(Code::kNothingToRemap);
  if (cameras.size() > 1) return refuse(Code::kSeveralCameras);
  if (!cameras.front().image_size) return refuse(Code::kFileWithoutSize);
  return cameras.front();
}

/// The camera of the new images, and the rotation from the frame of the source camera to its frame.
struct View {
  Camera camera;
  Transform T_camera_source = {};
};

/// If the file contains a rectification R and P of ROS: the camera of the rectified image. Otherwise the camera itself.
View rectified_view_of(const Rig& rig, const Camera& camera) {
  if (const std::optional<RectifiedImage> image = rectified_image(rig, camera))
    return {image->camera, image->T_rectified_camera};
  return {camera};
}

/// The only camera of a file, or the one with the given name if there are several. nullopt, with an error, if there is none.
std::optional<View> camera_of_file(const std::string& file, const std::string& name, Files& files, Diagnostics& diagnostics) {
  Inputs inputs;
  inputs.files = {file};
  const std::optional<Calibration> calibration = read_models(inputs, files, diagnostics);
  if (!calibration) return std::nullopt;
  const std::vector<Camera>& cameras = calibration->rig.cameras;
  const auto namesake = std::ranges::find(cameras, name, &Camera::name);
  if (cameras.size() == 1) return rectified_view_of(calibration->rig, cameras.front());
  if (namesake != cameras.end()) return rectified_view_of(calibration->rig, *namesake);
  std::vector<std::string> names;
  names.reserve(cameras.size());
  for (const Camera& camera : cameras) names.push_back(camera.name);
  if (names.empty()) names.emplace_back("none");
  diagnostics.add(Code::kViewOfSeveralCameras, {name, names}, {file, 0, 0});
  return std::nullopt;
}

/// Converts the source camera to a model. A large error of the fit does no harm: the new images are exactly those of the
/// result. nullopt, with errors, if the conversion fails.
std::optional<Camera> converted_source(const RemapRequest& request, const ModelInfo& model, const Camera& source,
                                       Diagnostics& diagnostics) {
  ConvertOptions options;
  options.model = model.id;
  options.max_angle_rad = request.inputs.max_angle_rad;
  options.bound = false;
  Diagnostics found;
  std::optional<Conversion> conversion = convert(source, options, found);
  for (const Diagnostic& entry : found.entries()) {
    if (entry.severity == Severity::kError) diagnostics.add(entry);
  }
  if (!conversion) return std::nullopt;
  return std::move(conversion->camera);
}

/// The size of an equirectangular image: twice as wide as high, with as many pixels per radian as the middle of the source
/// image, within the size limit.
ImageSize equirectangular_size(const Camera& source) {
  const auto [f_u, f_v] = central_focal_lengths(source.model);
  const double height = std::round(std::numbers::pi * std::max(f_u, f_v));
  const int rows = static_cast<int>(std::clamp(height, 1.0, 0.5 * kLongestSidePx));
  return {2 * rows, rows};
}

/// The camera of the new images, as the request chooses it. nullopt with errors.
std::optional<View> view_of(const RemapRequest& request, const Camera& source, Files& files, Diagnostics& diagnostics) {
  if (const auto* file = std::get_if<CameraOfFile>(&request.view))
    return camera_of_file(file->path, source.name, files, diagnostics);
  if (const auto* as = std::get_if<AsModel>(&request.view)) {
    const std::optional<Camera> camera =
        converted_source(request, as->model != nullptr ? *as->model : model_info(source.model), source, diagnostics);
    return camera ? std::optional(View{*camera}) : std::nullopt;
  }
  Camera camera = source;
  if (const auto* pinhole = std::get_if<PinholeView>(&request.view)) {
    if (pinhole->size) camera.image_size = pinhole->size;
    camera.model = pinhole_of_view(*camera.image_size, pinhole->full_fov_rad);
  }
  if (const auto* equirectangular = std::get_if<EquirectangularView>(&request.view))
    camera.image_size = equirectangular->size.value_or(equirectangular_size(source));
  return View{camera};
}

/// Adds the cameras and the map of the request to `result`. False with errors.
bool make_map(const RemapRequest& request, Files& files, RemapResult& result) {
  const std::optional<Camera> source = source_of(request, files, result.diagnostics);
  if (!source) return false;
  result.source = *source;
  std::optional<View> view = view_of(request, *source, files, result.diagnostics);
  if (!view || !fits_cv_remap(*source, result.diagnostics) || !fits_cv_remap(view->camera, result.diagnostics)) return false;
  result.view = std::move(view->camera);
  result.T_source_view = inverse(view->T_camera_source).value_or(Transform());
  result.is_equirectangular = std::holds_alternative<EquirectangularView>(request.view);
  if (result.is_equirectangular) {
    const std::string numbers =
        std::to_string(result.view.image_size->width) + " " + std::to_string(result.view.image_size->height);
    result.colmap_camera = "1 EQUIRECTANGULAR " + numbers + " " + numbers;
  }
  if (request.turn) {
    result.T_source_view =
        result.T_source_view * turned(request.turn->yaw_rad, request.turn->pitch_rad, request.turn->roll_rad);
  }
  const std::optional<double>& limit_rad = request.inputs.max_angle_rad;
  const std::optional<ImageMapper> mapper =
      result.is_equirectangular
          ? ImageMapper::to_equirectangular(*source, *result.view.image_size, result.T_source_view, limit_rad,
                                            result.diagnostics)
          : ImageMapper::between(*source, result.view, result.T_source_view, limit_rad, result.diagnostics);
  if (!mapper) return false;
  result.map = compute_map(*mapper, request.jobs);
  return true;
}

}  // namespace

RemapResult remap(const RemapRequest& request, Files& files) {
  RemapResult result;
  if (!make_map(request, files, result)) {
    result.status = worse(status_of(result.diagnostics), Status::kBadInput);
    return result;
  }
  result.mask = seen(result.map, *result.source.image_size);
  result.seen_share = static_cast<double>(std::ranges::count(result.mask, 255)) / static_cast<double>(result.mask.size());
  if (!(result.seen_share > 0.0)) result.status = Status::kRejected;
  return result;
}

}  // namespace fca
