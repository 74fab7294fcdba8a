// SPDX-License-Identifier: BSD-3-Clause
#include "fit_limits.h"

#include <algorithm>

namespace fca::internal {

FitLimits::FitLimits(const FitTarget& target, std::span<const ParameterRange> ranges) {
  for (std::size_t i = 0; i < target.parameters().size(); ++i) {
    const Parameter& p = target.parameters()[i];
    // The bounds of an open range are excluded, but the best fit may lie close to one: if a range keeps alpha of eucm above
    // 0.5, it becomes a pinhole as beta goes to 0.
    constexpr double kHair = 1e-6;
    const double furthest = std::min(p.furthest, kLargestParameter);
    lower[i] = std::max(p.lower + (p.open ? kHair : 0.0), -furthest);
    upper[i] = std::min(p.upper - (p.open ? kHair : 0.0), furthest);
    held[i] = target.held(i);
    for (const ParameterRange& range : ranges) {
      if (range.parameter.name() != p.name) continue;
      held[i] = false;
      lower[i] = std::max(lower[i], range.lower);
      upper[i] = std::min(upper[i], range.upper);
    }
  }
}

}  // namespace fca::internal
