// SPDX-License-Identifier: BSD-3-Clause
// Conditions on the parameters of a camera under which its image radius grows with the angle, for models whose radius may turn
// back inside a lens.
#pragma once

#include <fca/convert/fit_target.h>

#include <span>
#include <string_view>

namespace fca::internal {

/// A function of the parameters p and r = tan(angle from the axis). The camera's domain ends at the smallest r at which one of
/// its model's conditions is not positive. On the axis each condition is 1.
///
/// `derivatives`: null, or receives the derivatives by all parameters. The function is concave in p. So a tangent plane at any
/// p is nowhere below it, and the cameras whose condition holds at all r are a convex set.
using GrowthCondition = double (*)(const double* p, double r, double* derivatives);

/// The conditions of a model; empty if its fits need none.
[[nodiscard]] std::span<const GrowthCondition> growth_conditions(std::string_view model);

/// The r of each local minimum of one condition on [0, furthest] whose value is below `limit`, ascending.
[[nodiscard]] std::vector<double> minima_below(double limit, GrowthCondition condition, const double* p, double furthest);

}  // namespace fca::internal
