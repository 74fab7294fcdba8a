// SPDX-License-Identifier: BSD-3-Clause
#include "fit_limits.h"

#include <algorithm>

namespace fca::internal {

FitLimits::FitLimits(const FitTarget& target, std::span<const ParameterRange> ranges) {
  for (std::size_t i = 0; i < target.parameters().size(); ++i) {
    const Parameter& p = target.parameters()[i];
    // An open range does not contain its bounds, but the best fit may be close to one. (If a range keeps alpha of eucm above
    // 0.5, the camera becomes a pinhole as beta approaches 0.) A fit therefore stays this far inside.
    constexpr double kDistanceToOpenBound = 1e-6;
    const double furthest = std::min(p.furthest, kLargestParameter);
    lower[i] = std::max(p.lower + (p.open ? kDistanceToOpenBound : 0.0), -furthest);
    upper[i] = std::min(p.upper - (p.open ? kDistanceToOpenBound : 0.0), furthest);
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
