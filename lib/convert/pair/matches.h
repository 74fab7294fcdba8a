// SPDX-License-Identifier: BSD-3-Clause
// What both cameras of a pair see, and how a wrong pixel of either moves it across the rows of the rectified images.
#pragma once

#include <fca/convert/domain.h>
#include <fca/convert/lens.h>
#include <fca/rectify/rectify.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace fca::internal {

/// Rays and pixels of both cameras, one for one. The weights of each list sum to 1.
struct Matches {
  std::array<std::vector<Correspondence>, 2> seen;
  /// d row / d pixel in the rectified image, [rows of it / pixels of the camera's image].
  std::array<std::vector<Eigen::RowVector2d>, 2> row_slopes;
};

/// A camera and where it counts.
struct CameraOfPair {
  const Camera* camera;
  const CameraModel* start;  ///< What is fitted begins there: rays that it has no pixel for do not count.
  Domain domain;
  std::vector<Correspondence> samples;  ///< Of the domain.
};

/// Of points in the directions of the first camera's samples, at infinity and at ten baselines. Empty where no rectified image
/// shows what both see.
[[nodiscard]] Matches matches_of(const std::array<CameraOfPair, 2>& cameras, const Transform& T_second_first,
                                 const RectifiedPair& pair);

}  // namespace fca::internal
