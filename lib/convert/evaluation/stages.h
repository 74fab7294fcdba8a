// SPDX-License-Identifier: BSD-3-Clause
// The evaluation in two stages. A conversion that refits on more samples needs the first stage for each fit, and the second
// only once.
#pragma once

#include "scorer.h"

#include <vector>

namespace fca::internal {

/// An evaluation before its maximum is polished and its bound proven, and the points at which to begin that.
struct Score {
  ErrorStatistics statistics;
  std::vector<Point> worst;
};

[[nodiscard]] Score score_on_lattice(const Scorer& scorer);
[[nodiscard]] Score score_every_pixel(const Scorer& scorer);

/// The second stage: completes the result of score_on_lattice(). Scores every pixel instead if the options ask for it, or if
/// the largest error is so far above the rms that a lattice cannot tell how many pixels are near it.
[[nodiscard]] ErrorStatistics evaluate_all(const Scorer& scorer, Score lattice, const EvaluateOptions& options);

}  // namespace fca::internal
