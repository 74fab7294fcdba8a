// SPDX-License-Identifier: BSD-3-Clause
// The judge in two stages: a conversion that refits on more samples needs the first for each fit, and the second once.
#pragma once

#include "judge_scorer.h"

#include <vector>

namespace fca::internal {

/// A judgement without polished maximum and bound, and the points from which to look for them.
struct Score {
  Judgement judgement;
  std::vector<Point> worst;
};

[[nodiscard]] Score score_on_lattice(const Scorer& scorer);
[[nodiscard]] Score score_every_pixel(const Scorer& scorer);

}  // namespace fca::internal
