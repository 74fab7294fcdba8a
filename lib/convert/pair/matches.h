// SPDX-License-Identifier: BSD-3-Clause
// Points that both cameras of a pair see, and how a pixel error of either camera changes the row difference of the rectified
// images.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/lens.h>
#include <fca/rig/transform.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace fca::internal {

/// Corresponding rays and pixels of both cameras, with the same index. The weights of each list sum to 1.
struct Matches {
  std::array<std::vector<Correspondence>, 2> seen;
  /// The change of the row difference between the rectified images per pixel of error of that camera, in u and v.
  std::array<std::vector<Eigen::RowVector2d>, 2> derivatives;
};

/// A camera of a pair and the field of view on which it is compared.
struct CameraOfPair {
  const Camera* camera;
  const CameraModel* start;  ///< The model with which the fit starts; rays without a pixel in it are ignored.
  FieldOfView field_of_view;
  std::vector<Correspondence> samples;  ///< Samples of `field_of_view`.
};

/// Matches for points in the directions of the first camera's samples, at infinity and at ten baselines, up to 60 degrees from
/// both rectified axes. Empty if the cameras see nothing in common or are at the same place.
[[nodiscard]] Matches matches_of(const std::array<CameraOfPair, 2>& cameras, const Transform& T_second_first);

}  // namespace fca::internal
