// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scorer.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace fca::internal {

/// Takes the first `count` points of a batch.
using LatticeSink = std::function<void(const Batch& batch, std::size_t count)>;

/// At least 4,000 points (mostly under 6,000) of the image, border included, whose weights sum to the number of its pixels: the
/// pixels themselves if there are no more.
void score_lattice(const Scorer& scorer, const LatticeSink& sink);
[[nodiscard]] std::vector<Point> score_lattice(const Scorer& scorer);

}  // namespace fca::internal
