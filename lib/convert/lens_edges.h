// SPDX-License-Identifier: BSD-3-Clause
// The edges of what is scored inside an image, where errors are often largest: none of the area, and lattices pass them by.
#pragma once

#include "judge_scorer.h"

#include <functional>
#include <vector>

namespace fca::internal {

/// The point of an edge at an azimuth [rad], a hair inside; not scored where that lies outside the image.
using LensEdge = std::function<Point(double azimuth)>;

/// The cone of the domain, or of the target's reach inside it, and the domain's circle. The source is a model, and the scorer
/// outlives the edges.
[[nodiscard]] std::vector<LensEdge> lens_edges(const Scorer& scorer);

}  // namespace fca::internal
