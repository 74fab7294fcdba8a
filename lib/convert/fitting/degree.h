// SPDX-License-Identifier: BSD-3-Clause
// Chooses the degree of the polynomial of a fitted model.
#pragma once

#include "fit_field_of_view.h"

#include <vector>

namespace fca::internal {

/// A fit with a rms below 0.01 px, or at most 1.1 times that of the best degree, needs no higher degree.
inline constexpr double kGoodEnoughPx = 0.01;
inline constexpr double kNearlyAsGood = 1.1;

/// A degree that a target may be fitted with, and the ranges of parameters that lead to this degree.
struct DegreeRanges {
  int degree = 0;  ///< 0 if the model has no degree to choose.
  std::vector<ParameterRange> ranges;
};

/// The degrees that the options allow, the lowest first. There is only one if the options set a degree or have a range for a
/// coefficient beyond the lowest degree, or if the target has no degree to choose.
[[nodiscard]] std::vector<DegreeRanges> degrees_to_try(const ModelInfo& target, const ConvertOptions& options);

struct DegreeFit {
  FieldOfViewFit fit;
  std::vector<ParameterRange> ranges;  ///< The ranges of this fit.
  int degree = 0;                      ///< 0 if the model has no degree to choose.
  std::vector<UnusualParameter> unusual;
};

/// Fits the target with the degree of task.options. Without one, chooses the lowest degree whose rms is within 10 % of the best
/// or below 0.01 px. A degree that covers less of the image than the lowest one, or has rays at fewer pixels of the border, is
/// not taken. The chosen fit is the first of the result. Those of lower degrees follow, the highest first, for a caller who
/// needs more than a small rms. If the options have a range for a coefficient beyond the lowest degree, the caller's ranges
/// alone decide, and there is one fit. At least one fit is returned; it may have no model.
[[nodiscard]] std::vector<DegreeFit> fit_degrees(const FitTask& task);

}  // namespace fca::internal
