// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "judge_scorer.h"

#include <vector>

namespace fca::internal {

/// About 5,000 scored points of the image, border included, whose weights sum to the number of its pixels.
[[nodiscard]] std::vector<Point> score_lattice(const Scorer& scorer);

}  // namespace fca::internal
