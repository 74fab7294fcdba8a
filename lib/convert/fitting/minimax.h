// SPDX-License-Identifier: BSD-3-Clause
// Finds the camera with the smallest maximum error over the field of view, near a least-squares fit.
#pragma once

#include "../evaluation/scorer.h"

#include <fca/convert/convert.h>

#include <span>
#include <string>
#include <vector>

namespace fca::internal {

/// The result of fit_largest_error().
struct MinimaxFit {
  CameraModel model;
  int iterations = 0;
  std::vector<std::string> at_bound;  ///< Names of the parameters that ended at a bound.
};

/// Starting from the camera `start`, minimises its largest error [px] within the parameters' ranges. The rays are those of the
/// field of view within `target_max_angle_rad` of the axis for which `start` has a pixel. Finds a local minimum near `start`
/// and does not search for others.
///
/// The first minimisation is over some hundred points of the evaluation's lattice and of the lens's edge. Each further one
/// includes all points whose error has become larger than at the points before (Remez' exchange, but no point is removed).
/// Every point must stay in the target's domain, so that the search never reduces the error by covering less of the image.
///
/// The caller must evaluate the result: if there is nothing to gain, its largest error may be larger than that of `start`.
[[nodiscard]] MinimaxFit fit_largest_error(const CameraModel& source, const CameraModel& start,
                                           const FieldOfView& field_of_view, double target_max_angle_rad,
                                           std::span<const ParameterRange> ranges);

}  // namespace fca::internal
