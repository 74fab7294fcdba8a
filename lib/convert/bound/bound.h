// SPDX-License-Identifier: BSD-3-Clause
// Proves an upper bound of a conversion's error. The bound is also valid between the pixels that were evaluated.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/models/camera_model.h>

#include <limits>

namespace fca::internal {

/// The result of bound_error().
struct ErrorBound {
  /// No error in the field of view is larger [px]. Infinite if there is no proof.
  double bound = std::numeric_limits<double>::infinity();
  double seen = 0.0;    ///< The largest error that is known to occur in the field of view [px].
  Pixel seen_at{};      ///< The source's pixel with that error; not set if the error is the caller's `seen`.
  int evaluations = 0;  ///< The number of cells and strips that were evaluated; a strip has the cost of several cells.
};

/// An upper bound of |target(ray(u)) - u| over all pixels u of the field of view whose ray is in the target's domain and within
/// `target_max_angle_rad` of the axis. `seen`: an error [px] that is known to occur. `budget`: the search ends after so many
/// evaluations. If they do not suffice, the bound is larger than necessary, but still valid.
///
/// The method is branch and bound (Moore 1966, Hansen & Walster 2004). Rays are divided into cells: ranges of the angle from
/// the axis and of the azimuth. The cell with the largest bound is divided next, until no bound exceeds 1.01 times the largest
/// known error. On strips of angles, the difference of the models is replaced by Taylor polynomials with rigorous remainders
/// (polar.h), so that equal terms of both models cancel before any bound is computed. The bound of a cell is that of the
/// polynomials' tangent plane at the cell's centre plus bounds of the second-order terms. Cells outside the image are dropped.
/// Cells partly outside are treated as if they were inside.
[[nodiscard]] ErrorBound bound_error(const CameraModel& source, const CameraModel& target, const FieldOfView& field_of_view,
                                     double target_max_angle_rad, double seen, int budget = 20'000);

}  // namespace fca::internal
