// SPDX-License-Identifier: BSD-3-Clause
// The evaluation of a conversion in two stages. A conversion that makes several fits needs the first stage for each fit, but
// the second stage only for the fit that is chosen.
#pragma once

#include "scorer.h"

#include <vector>

namespace fca::internal {

/// The result of the first stage.
struct Score {
  ErrorStatistics statistics;  ///< Without a bound. The maximum is that of the evaluated points.
  std::vector<Point> worst;    ///< The points with the largest errors, the worst first: starts for the search of the maximum.
};

/// The first stage on a lattice of points (lattice.h).
[[nodiscard]] Score score_on_lattice(const Scorer& scorer);
/// The first stage on every pixel of the image. The coverage also has the numbers of pixels.
[[nodiscard]] Score score_every_pixel(const Scorer& scorer);

/// The second stage: searches the maximum between the points and, if the options have `bound`, proves a bound. `lattice`: the
/// result of score_on_lattice(); it is not used if the options require every pixel. Sums errors over every pixel, too, if the
/// largest error is so far above the rms that a lattice has too few points near it.
[[nodiscard]] ErrorStatistics evaluate_all(const Scorer& scorer, Score lattice, const EvaluateOptions& options);

}  // namespace fca::internal
