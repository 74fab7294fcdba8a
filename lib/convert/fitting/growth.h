// SPDX-License-Identifier: BSD-3-Clause
// Conditions on a camera's parameters under which the image radius grows with the angle from the axis. They are for models
// whose radius may start to shrink within a lens's field of view (radtan).
#pragma once

#include <fca/convert/fit_target.h>

#include <span>
#include <string_view>

namespace fca::internal {

/// A function of the parameters p and of r = tan(angle from the axis), for angles below 90 degrees. The condition holds where
/// the value is positive. On the axis the value is 1. The camera's domain ends at the smallest r at which the value of a
/// condition of its model is zero or negative.
///
/// `derivatives` receives the derivatives with respect to all parameters unless it is null. The function is concave in p. Each
/// tangent plane is therefore nowhere below the function, and the cameras whose condition holds at all r are a convex set.
using GrowthCondition = double (*)(const double* p, double r, double* derivatives);

/// The conditions of the model with the id `model`; empty if fits of this model need none.
[[nodiscard]] std::span<const GrowthCondition> growth_conditions(std::string_view model);

/// Returns the r of each local minimum of a condition on [0, largest_r] whose value is below `limit`, in ascending order.
[[nodiscard]] std::vector<double> minima_below(double limit, GrowthCondition condition, const double* p, double largest_r);

}  // namespace fca::internal
