// SPDX-License-Identifier: BSD-3-Clause
// The judge in two stages: a conversion that refits on more samples needs the first for each fit, and the second once.
#pragma once

#include "scorer.h"

#include <vector>

namespace fca::internal {

/// A judgement without polished maximum and bound, and the points from which to look for them.
struct Score {
  Judgement judgement;
  std::vector<Point> worst;
};

[[nodiscard]] Score score_on_lattice(const Scorer& scorer);
[[nodiscard]] Score score_every_pixel(const Scorer& scorer);

/// Everything a judgement says, from what the lattice says; of every pixel if the options say so, or where the worst error is
/// so far above the others that a lattice cannot tell how often it is met.
[[nodiscard]] Judgement judge_all(const Scorer& scorer, Score lattice, const JudgeOptions& options);

}  // namespace fca::internal
