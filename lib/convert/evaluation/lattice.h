// SPDX-License-Identifier: BSD-3-Clause
// The points of an image at which a conversion is evaluated. README.md explains how they are chosen.
#pragma once

#include "scorer.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace fca::internal {

/// Receives the first `count` points of a batch.
using LatticeSink = std::function<void(const Batch& batch, std::size_t count)>;

/// Evaluates points of the image and of its border and passes them to `sink`. At least 4,000 of them have the verdict kScored,
/// mostly fewer than 6,000; less than 4,000 only if hardly any part of the image is scored. The weights of all points sum to
/// the number of pixels of the image. In an image of at most 5,000 pixels, the points are the pixels.
void score_lattice(const Scorer& scorer, const LatticeSink& sink);
/// The same points as a list.
[[nodiscard]] std::vector<Point> score_lattice(const Scorer& scorer);

}  // namespace fca::internal
