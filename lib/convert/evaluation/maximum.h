// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scorer.h"

#include <span>

namespace fca::internal {

/// The local maximum of the error that a climb from the pixel `start` reaches.
[[nodiscard]] Point climb(const Scorer& scorer, const Pixel& start);

/// Replaces the largest error of `result` by a local maximum between the scored points, if that is larger. With `prove`, and if
/// source and target are both models, also proves an upper bound of the error. `worst`: points to climb from, the worst first.
void find_maximum(const Scorer& scorer, std::span<const Point> worst, bool prove, ErrorStatistics& result);

}  // namespace fca::internal
