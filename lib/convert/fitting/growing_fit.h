// SPDX-License-Identifier: BSD-3-Clause
// Fits the best camera whose image radius grows up to the outermost sample, for models whose best camera turns back before it.
#pragma once

#include "growth.h"

#include <fca/convert/fit_target.h>

#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

struct GrowingTask {
  const FitTarget& target;
  std::span<const GrowthCondition> conditions;
  std::span<const Correspondence> samples;
  std::span<const ParameterRange> ranges;
};

/// Minimises the cost from `start` among the cameras whose growth conditions hold up to the outermost sample. Never worse than
/// the start. nullopt if the start, moved into the ranges, is no such camera.
///
/// A Gauss-Newton step goes to the minimum of a quadratic on a convex set of cameras. There is one condition for each r, thus
/// infinitely many. Those at the minima over r at the step's end are added until none is violated there (the cutting planes of
/// Kelley 1960).
[[nodiscard]] std::optional<FoundFit> fit_growing(const GrowingTask& task, const ParameterValues& start);

}  // namespace fca::internal
