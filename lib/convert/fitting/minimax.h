// SPDX-License-Identifier: BSD-3-Clause
// Finds the camera near a least-squares fit that has the smallest maximum error over the field of view.
#pragma once

#include "../evaluation/scorer.h"

#include <fca/convert/convert.h>

#include <span>
#include <string>
#include <vector>

namespace fca::internal {

/// The result of the search: the camera, the number of steps, and the names of the parameters that ended at a bound.
struct MinimaxFit {
  CameraModel model;
  int iterations = 0;
  std::vector<std::string> at_bound;
};

/// Minimises the largest error [px] of `start` over the rays within `target_max_angle_rad` of the axis that it can represent,
/// within the ranges. Begins with a few points of the evaluation's lattice and of the lens's edge. Then adds, again and again,
/// all points at which the error turns out to be larger than at those (Remez' exchange, but no point is removed). Every point
/// stays in the target's domain, so that coverage is not traded for a smaller error. Finds a local minimum near `start`; other
/// minima are not searched for. The caller must evaluate the result: where nothing was to be gained, its largest error may be
/// larger than that of `start`.
[[nodiscard]] MinimaxFit fit_largest_error(const CameraModel& source, const CameraModel& start,
                                           const FieldOfView& field_of_view, double target_max_angle_rad,
                                           std::span<const ParameterRange> ranges);

}  // namespace fca::internal
