// SPDX-License-Identifier: BSD-3-Clause
// The best camera whose radius grows as far as its samples: for models whose best one of all turns back before.
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

/// From `start` downhill along cameras whose conditions hold as far as the outermost sample: never worse than the start.
/// Nothing where the start, put into the ranges, is no such camera.
///
/// A Gauss-Newton step is the lowest point of a quadratic among a convex set of cameras. Of the infinitely many conditions (one
/// at each r) those at the lowest places of the step's end are added until none is violated there (the cutting planes of
/// Kelley 1960).
[[nodiscard]] std::optional<FoundFit> fit_growing(const GrowingTask& task, const ParameterValues& start);

}  // namespace fca::internal
