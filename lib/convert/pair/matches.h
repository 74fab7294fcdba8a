// SPDX-License-Identifier: BSD-3-Clause
// What both cameras of a pair see, and how a wrong pixel of either moves it across the rows of the rectified images.
#pragma once

#include <fca/convert/domain.h>
#include <fca/convert/lens.h>
#include <fca/rig/transform.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace fca::internal {

/// Rays and pixels of both cameras, one for one. The weights of each list sum to 1.
struct Matches {
  std::array<std::vector<Correspondence>, 2> seen;
  /// By how many rows the two rectified images of a match come to differ for each pixel by which that camera is off in u and v.
  std::array<std::vector<Eigen::RowVector2d>, 2> slopes;
};

/// A camera and where it counts.
struct CameraOfPair {
  const Camera* camera;
  const CameraModel* start;  ///< What is fitted begins there: rays that it has no pixel for do not count.
  Domain domain;
  std::vector<Correspondence> samples;  ///< Of the domain.
};

/// Of points in the directions of the first camera's samples, at infinity and at ten baselines, up to 60 deg from both axes.
/// Empty where both see nothing in common, or stand at one place.
[[nodiscard]] Matches matches_of(const std::array<CameraOfPair, 2>& cameras, const Transform& T_second_first);

}  // namespace fca::internal
