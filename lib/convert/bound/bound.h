// SPDX-License-Identifier: BSD-3-Clause
// A proof of how large a conversion's error can be, between the pixels that were looked at, too.
#pragma once

#include <fca/convert/domain.h>
#include <fca/models/camera_model.h>

#include <limits>

namespace fca::internal {

struct ErrorBound {
  double bound = std::numeric_limits<double>::infinity();  ///< px; no error of the domain is larger. Infinite: not proven.
  double seen = 0.0;                                       ///< px; an error that the domain has.
  Pixel seen_at{};                                         ///< The source's pixel of it.
  int evaluations = 0;
};

/// An upper bound of |target(ray(u)) - u| over all u of the domain whose ray the target reaches and that lie within
/// `target_reach_rad` of the axis; `seen` is an error known to occur.
///
/// Angle from the axis and azimuth are cut into cells until no cell's upper bound exceeds 1.01 of an error that was seen (by
/// the caller or here), always the worst cell first (branch and bound: Moore 1966, Hansen & Walster 2004). On strips of angles
/// both models are replaced by Taylor polynomials with rigorous remainders (polar.h), so that what they have in common
/// cancels before anything is estimated; a cell's bound is the polynomial's tangent plane at its centre plus the largest
/// second-order terms. Cells outside the image fall away, cells partly outside count in full. If `budget` evaluations do not
/// suffice, the bound is looser than that, but as true.
[[nodiscard]] ErrorBound bound_error(const CameraModel& source, const CameraModel& target, const Domain& domain,
                                     double target_reach_rad, double seen, int budget = 20'000);

}  // namespace fca::internal
