// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scorer.h"

#include <span>

namespace fca::internal {

/// The local maximum of the error that is reached from the pixel `start` by always going to a point with a larger error.
[[nodiscard]] Point climb(const Scorer& scorer, const Pixel& start);

/// Searches for larger errors between the scored points and replaces the largest error of `result` if there is one. With
/// `prove`, and if source and target are both models, also proves an upper bound of the error. `worst`: the points at which the
/// search begins, the worst first.
void find_maximum(const Scorer& scorer, std::span<const Point> worst, bool prove, ErrorStatistics& result);

}  // namespace fca::internal
