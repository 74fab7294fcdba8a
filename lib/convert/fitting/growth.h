// SPDX-License-Identifier: BSD-3-Clause
// Where the image radius of a camera grows: conditions on its parameters, for models whose radius may turn back inside a lens.
#pragma once

#include <fca/convert/fit_target.h>

#include <span>
#include <string_view>

namespace fca::internal {

/// A number that is positive at r = tan(angle from the axis) where the camera of the parameters p may reach that far: the
/// camera's domain ends at the first r where one condition of its model is not. On the axis it is 1.
///
/// `slopes`: null, or where its derivatives by all parameters go. It is concave in p. So the plane that touches it at any p
/// lies nowhere below it, and the cameras whose condition holds at all r are a convex set.
using GrowthCondition = double (*)(const double* p, double r, double* slopes);

/// Those of a model; none if its fits need none.
[[nodiscard]] std::span<const GrowthCondition> growth_conditions(std::string_view model);

/// Of one condition on [0, furthest]: the r of each local minimum that is below `limit`, ascending.
[[nodiscard]] std::vector<double> minima_below(double limit, GrowthCondition condition, const double* p, double furthest);

}  // namespace fca::internal
