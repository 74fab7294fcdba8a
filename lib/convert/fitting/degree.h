// SPDX-License-Identifier: BSD-3-Clause
// Chooses the degree of the polynomial of a fitted model (ocamcalib).
#pragma once

#include "fit_field_of_view.h"

#include <vector>

namespace fca::internal {

/// A fit needs no higher degree if its rms is below kGoodEnoughPx, or at most kNearlyAsGood times that of the best degree.
inline constexpr double kGoodEnoughPx = 0.01;
inline constexpr double kNearlyAsGood = 1.1;

/// A degree, and the ranges of parameters with which a fit has this degree.
struct DegreeRanges {
  int degree = 0;                      ///< 0 if the model is no polynomial of variable degree.
  std::vector<ParameterRange> ranges;  ///< The options' ranges, and unlimited ones for further coefficients.
};

/// Returns the degrees that the options allow, the lowest first. There is only one if the options set a degree or have a range
/// for a coefficient beyond the lowest degree, or if the target is no polynomial of variable degree.
[[nodiscard]] std::vector<DegreeRanges> degrees_to_try(const ModelInfo& target, const ConvertOptions& options);

/// A fit with one degree.
struct DegreeFit {
  FieldOfViewFit fit;
  std::vector<ParameterRange> ranges;     ///< The ranges of this fit.
  int degree = 0;                         ///< 0 if the model is no polynomial of variable degree.
  std::vector<UnusualParameter> unusual;  ///< The parameters outside their usual range (usual.h).
};

/// Fits the target with the degree of task.options. If the options set no degree, chooses the lowest degree whose rms is below
/// 0.01 px or at most 10 % above the smallest. Ignores a degree that covers less of the image than the lowest degree, or has
/// rays at fewer pixels of the image's border. If the options have a range for a coefficient beyond the lowest degree, only
/// these ranges decide, and there is one fit.
///
/// The chosen fit is the first of the result. The fits of lower degrees follow, the highest degree first: a caller may prefer
/// one of them for other reasons than the rms. The result has at least one fit, which may have no model.
[[nodiscard]] std::vector<DegreeFit> fit_degrees(const FitTask& task);

}  // namespace fca::internal
