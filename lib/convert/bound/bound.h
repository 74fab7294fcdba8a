// SPDX-License-Identifier: BSD-3-Clause
// Proves an upper bound of a conversion's error, also between the pixels that were evaluated.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/models/camera_model.h>

#include <limits>

namespace fca::internal {

struct ErrorBound {
  /// px; no error in the field of view is larger. Infinite: not proven.
  double bound = std::numeric_limits<double>::infinity();
  double seen = 0.0;  ///< px; the largest error known to occur in the field of view.
  Pixel seen_at{};    ///< The source's pixel at which it occurs, if it exceeds the caller's `seen`.
  int evaluations = 0;
};

/// An upper bound of |target(ray(u)) - u| over all pixels u of the field of view whose ray is in the target's domain and within
/// `target_max_angle_rad` of the axis. `seen`: px, an error known to occur.
///
/// Angle from the axis and azimuth are divided into cells, always the cell with the largest bound first, until no bound exceeds
/// 1.01 times the largest error seen, by the caller or here (branch and bound: Moore 1966, Hansen & Walster 2004). On strips of
/// angles both models are replaced by Taylor polynomials with rigorous remainders (polar.h), so that what they have in common
/// cancels before anything is estimated. A cell's bound is the polynomial's tangent plane at its centre plus the largest
/// second-order terms. Cells outside the image are dropped; cells partly outside count in full. If `budget` evaluations do not
/// suffice, the bound is looser but still valid.
[[nodiscard]] ErrorBound bound_error(const CameraModel& source, const CameraModel& target, const FieldOfView& field_of_view,
                                     double target_max_angle_rad, double seen, int budget = 20'000);

}  // namespace fca::internal
