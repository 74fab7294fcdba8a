// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scorer.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace fca::internal {

/// Receives the first `count` points of a batch.
using LatticeSink = std::function<void(const Batch& batch, std::size_t count)>;

/// Scores points of the image and of its border and passes them to `sink`: at least 4,000 that count as scored (mostly under
/// 6,000; fewer only where next to nothing of the image does). The weights of all points sum to the number of pixels of the
/// image. An image of at most 5,000 pixels is scored pixel by pixel instead.
void score_lattice(const Scorer& scorer, const LatticeSink& sink);
[[nodiscard]] std::vector<Point> score_lattice(const Scorer& scorer);

}  // namespace fca::internal
