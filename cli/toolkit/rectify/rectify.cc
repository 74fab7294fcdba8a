// SPDX-License-Identifier: BSD-3-Clause
#include <fca/toolkit/rectify.h>

#include "degrees.h"
#include "like_opencv.h"
#include "remap/compute_map.h"
#include "settings.h"
#include "source_pair.h"
#include "stereo_rectify.h"

#include <fca/code.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca {

namespace {

/// The rectification in the files, to which the valid region of each view is added. nullopt, with an error, if a view has no
/// valid region. `source` must contain a rectification.
std::optional<RectifiedPair> rectification_in_files(const SourcePair& source, Diagnostics& diagnostics) {
  RectifiedPair pair = *source.stated;
  if (!pair.size) pair.size = source.cameras[0].image_size;
  for (std::size_t i = 0; i < 2; ++i) {
    pair.views.at(i).valid = valid_region(source.cameras.at(i), pair, i, *pair.size);
    if (pair.views.at(i).valid) continue;
    diagnostics.add(Code::kRectifyNoValidPart, {source.cameras.at(i).name});
    return std::nullopt;
  }
  return pair;
}

/// Computes the rectification, with OpenCV if the request has its function (then `result.ours` also gets our own). nullopt,
/// with errors, if that fails.
std::optional<RectifiedPair> computed_rectification(const RectifyRequest& request, const SourcePair& source,
                                                    RectifyResult& result) {
  const auto& [first, second] = source.cameras;
  RectifyOptions options{request.view, request.size};
  const auto* by_alpha = std::get_if<RectifiedByAlpha>(&request.view);
  const double alpha = by_alpha != nullptr ? by_alpha->alpha : 0.0;
  if (request.like_opencv) options.view = RectifiedByAlpha{alpha};
  std::optional<RectifiedPair> ours = rectify(first, second, source.T_second_first, options, result.diagnostics);
  if (!request.like_opencv || !ours) return ours;
  std::optional<RectifiedPair> by_opencv =
      rectify_with_opencv(request.like_opencv, source.cameras, source.T_second_first, alpha, *ours->size, result.diagnostics);
  if (!by_opencv) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i)
    by_opencv->views.at(i).valid = valid_region(source.cameras.at(i), *by_opencv, i, *ours->size);
  result.ours = std::move(ours);
  return by_opencv;
}

/// Warns if the rectification in a file contradicts the pose in the same file. The rectification is used nevertheless.
void warn_of_contradiction(const SourcePair& source, const RectifiedPair& pair, const std::string& file,
                           Diagnostics& diagnostics) {
  constexpr double kMmPerM = 1000.0;
  const Transform pose_in_rectification = pose_of(pair);
  const double angle = kDegreesPerRadian * angle_between(pose_in_rectification, source.T_second_first);
  const double metres = distance_between(pose_in_rectification, source.T_second_first);
  constexpr double kNoticeableAngle = 0.05;   // deg
  constexpr double kNoticeableShare = 0.005;  // of the distance between the cameras
  if (angle <= kNoticeableAngle && metres <= kNoticeableShare * distance_of(source.T_second_first)) return;
  const Message facts = {Code::kRectificationContradicts,
                         {source.cameras[0].name, source.cameras[1].name, angle, kMmPerM * metres}};
  diagnostics.add({Severity::kWarning, facts, {file, 0, 0}});
}

/// Copies the cameras and their pose to the result, with the left (upper) camera first.
void put_in_order(SourcePair source, RectifyResult& result) {
  if (result.pair.offset_m < 0.0) {
    result.is_exchanged = true;
    result.pair = exchanged(result.pair);
    if (result.ours) result.ours = exchanged(*result.ours);
    std::swap(source.cameras[0], source.cameras[1]);
    source.T_second_first = inverse(source.T_second_first).value_or(Transform());
  }
  result.cameras = std::move(source.cameras);
  result.T_second_first = source.T_second_first;
  result.is_rectified = source.is_rectified;
}

/// The horizontal field of view [rad] between the outer edges of the first and the last pixels.
double field_across(const RectifiedPair& pair, const ImageSize& size) {
  const double centre = pair.views[0].centre[0];
  return std::atan((centre + 0.5) / pair.focal_lengths[0]) + std::atan((size.width - 0.5 - centre) / pair.focal_lengths[0]);
}

/// Adds the maps of both cameras to the result. False, with errors, if that fails.
bool add_maps(const RectifyRequest& request, RectifyResult& result) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Camera& source = result.cameras.at(i);
    const Camera target = rectified_camera(result.pair, i, result.size);
    if (!fits_cv_remap(source, result.diagnostics) || !fits_cv_remap(target, result.diagnostics)) return false;
    const std::optional<Transform> T_source_target = inverse(result.pair.views.at(i).T_rectified_camera);
    const std::optional<ImageMapper> mapper =
        T_source_target
            ? ImageMapper::between(source, target, *T_source_target, request.inputs.max_angle_rad, result.diagnostics)
            : std::nullopt;
    if (!mapper) return false;
    result.maps.push_back(compute_map(*mapper, request.jobs));
    const std::vector<std::uint8_t> mask = seen(result.maps.back(), *source.image_size);
    result.seen_shares.at(i) = static_cast<double>(std::ranges::count(mask, 255)) / static_cast<double>(mask.size());
  }
  return true;
}

/// Fills the result. False if an error ends the rectification.
bool run(const RectifyRequest& request, Files& files, RectifyResult& result) {
  const std::optional<Calibration> calibration = read_models(request.inputs, files, result.diagnostics);
  if (!calibration) return false;
  std::optional<SourcePair> source = source_pair(calibration->rig, request.inputs.files.front(), result.diagnostics);
  if (!source) return false;
  if (!source->cameras[0].image_size || !source->cameras[1].image_size) {
    result.diagnostics.add(Code::kFileWithoutSize, {}, {request.inputs.files.front(), 0, 0});
    return false;
  }
  const bool is_view_requested = !std::holds_alternative<std::monostate>(request.view) || request.size || request.like_opencv;
  result.is_stated = source->stated && !is_view_requested;
  std::optional<RectifiedPair> pair =
      result.is_stated ? rectification_in_files(*source, result.diagnostics) : computed_rectification(request, *source, result);
  if (!pair) return false;
  if (result.is_stated) warn_of_contradiction(*source, *pair, request.inputs.files.front(), result.diagnostics);
  result.size = *pair->size;
  result.pair = *std::move(pair);
  put_in_order(*std::move(source), result);
  result.full_fov_rad = field_across(result.pair, result.size);
  const auto& [first, second] = result.cameras;
  result.disparity =
      vertical_disparity({first, first.model}, {second, second.model}, result.T_second_first, result.pair, result.size);
  if (!result.disparity) {
    result.diagnostics.add(Code::kRectifyNoValidPart, {first.name + " and " + second.name});
    return false;
  }
  if (request.maps && !add_maps(request, result)) return false;
  return request.to == nullptr || write_settings(request, *calibration, result);
}

}  // namespace

RectifyResult rectify(const RectifyRequest& request, Files& files) {
  RectifyResult result;
  if (!run(request, files, result)) result.status = worse(status_of(result.diagnostics), Status::kBadInput);
  return result;
}

}  // namespace fca
