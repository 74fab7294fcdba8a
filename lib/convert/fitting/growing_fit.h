// SPDX-License-Identifier: BSD-3-Clause
// Finds the best camera whose image radius grows up to the outermost sample, for models whose best camera of all may have a
// radius that shrinks before.
#pragma once

#include "growth.h"

#include <fca/convert/fit_target.h>

#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// The input of fit_growing(). The object refers to its members, which must outlive it.
struct GrowingTask {
  const FitTarget& target;
  std::span<const GrowthCondition> conditions;
  std::span<const Correspondence> samples;
  std::span<const ParameterRange> ranges;
};

/// Minimises the cost, starting from `start`, among the cameras whose growth conditions hold up to the outermost sample. The
/// result is never worse than the start. nullopt if the start, moved into the ranges, is not such a camera.
///
/// A Gauss-Newton step goes to the minimum of a quadratic on the convex set of these cameras. The set has infinitely many
/// conditions: those of the model at each r. A step begins with finitely many planes in place of these conditions. Where the
/// camera at its end violates a condition, planes at the condition's minima over r are added, and the step is computed again,
/// until none is violated (the cutting planes of Kelley 1960).
[[nodiscard]] std::optional<FoundFit> fit_growing(const GrowingTask& task, const ParameterValues& start);

}  // namespace fca::internal
