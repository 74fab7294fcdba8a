// SPDX-License-Identifier: BSD-3-Clause
// The degree of a polynomial that a camera is fitted as.
#pragma once

#include "fit_domain.h"

#include <vector>

namespace fca::internal {

struct DegreeFit {
  DomainFit fit;
  std::vector<ParameterRange> ranges;  ///< That it was made with.
  int degree = 0;                      ///< 0: the target has none to choose.
};

/// fit_domain with task.options.degree. Without one: of all degrees the lowest whose rms is within 10 % of the best, or below
/// 0.01 px, that reaches as much of the image as the lowest degree does, and turns nowhere inside it where that does not;
/// behind it those of lower degrees, the highest first, for who wants more of a fit than that. Where the options have a range
/// for a coefficient beyond the lowest degree, all of these are the caller's. At least one.
[[nodiscard]] std::vector<DegreeFit> fit_degrees(const FitTask& task);

}  // namespace fca::internal
