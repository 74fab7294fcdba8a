// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scorer.h"

#include <span>

namespace fca::internal {

/// The top of the hill of errors on whose slope the pixel lies.
[[nodiscard]] Point climb(const Scorer& scorer, const Pixel& start);

/// Replaces the largest error of `result` by the largest one nearby, between the points that were scored, and proves a bound
/// where that is asked and the target is a model. `worst`: points to start from, the worst first.
void find_maximum(const Scorer& scorer, std::span<const Point> worst, bool prove, Judgement& result);

}  // namespace fca::internal
