// SPDX-License-Identifier: BSD-3-Clause
// The degree of a polynomial that a camera is fitted as.
#pragma once

#include "fit_domain.h"

#include <vector>

namespace fca::internal {

/// Nobody looks for less of a polynomial's error, nor for a tenth less.
inline constexpr double kGoodEnoughPx = 0.01;
inline constexpr double kNearlyAsGood = 1.1;

/// A degree that a target may be fitted with, and the ranges which make it that.
struct DegreeRanges {
  int degree = 0;  ///< 0: the target has none to choose.
  std::vector<ParameterRange> ranges;
};

/// Those to choose from by the options, the lowest first. Where the options state a degree, or have a range for a coefficient
/// beyond the lowest, or where the target has none, it is one.
[[nodiscard]] std::vector<DegreeRanges> degrees_to_try(const ModelInfo& target, const ConvertOptions& options);

struct DegreeFit {
  DomainFit fit;
  std::vector<ParameterRange> ranges;  ///< That it was made with.
  int degree = 0;                      ///< 0: the target has none to choose.
  std::vector<UnusualParameter> unusual;
};

/// fit_domain with task.options.degree. Without one: of all degrees the lowest whose rms is within 10 % of the best, or below
/// 0.01 px, that reaches as much of the image as the lowest degree does, and turns nowhere inside it where that does not;
/// behind it those of lower degrees, the highest first, for who wants more of a fit than that. Where the options have a range
/// for a coefficient beyond the lowest degree, all of these are the caller's. At least one.
[[nodiscard]] std::vector<DegreeFit> fit_degrees(const FitTask& task);

}  // namespace fca::internal
