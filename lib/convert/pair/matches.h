// SPDX-License-Identifier: BSD-3-Clause
// Points that both cameras of a pair see, and how much a pixel error of either camera changes the row difference: the
// difference between the rows of a point in the two rectified images.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/lens.h>
#include <fca/rig/transform.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace fca::internal {

/// Points that both cameras see. The lists of both cameras have the same length; entries with the same index belong to the same
/// point.
struct Matches {
  /// The ray and the pixel of each point in each camera. The weights of each list sum to 1.
  std::array<std::vector<Correspondence>, 2> seen;
  /// The change of the row difference of each point per pixel of error of each camera, in u and in v.
  std::array<std::vector<Eigen::RowVector2d>, 2> derivatives;
};

/// A camera of a pair and the field of view on which it is compared.
struct CameraOfPair {
  const Camera* camera;
  const CameraModel* start;  ///< The model with which the fit starts. Rays that have no pixel in it are ignored.
  FieldOfView field_of_view;
  std::vector<Correspondence> samples;  ///< Samples of `field_of_view`.
};

/// Points in the directions of the first camera's samples, at infinity and at a distance of ten baselines, up to 60 degrees
/// from the axis of both rectified cameras. Empty if no such point is in both images, or if the cameras are at the same place.
[[nodiscard]] Matches matches_of(const std::array<CameraOfPair, 2>& cameras, const Transform& T_second_first);

}  // namespace fca::internal
