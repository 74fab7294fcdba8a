// SPDX-License-Identifier: BSD-3-Clause
// The edges of what is scored inside an image, where errors are often largest: none of the area, and lattices pass them by.
#pragma once

#include "scorer.h"

#include <functional>
#include <optional>
#include <vector>

namespace fca::internal {

/// Where what is scored ends inside the image.
struct LensEdge {
  /// Its pixel at an azimuth [rad], a hair inside; nothing where that lies outside the image.
  std::function<std::optional<Pixel>(double azimuth)> at;
  /// Whether a scored point lies on it, as near as the lattice's do.
  std::function<bool(const Point& point)> passes;
};

/// Those of the cone of the domain, or of the target's reach inside it, and of the domain's circle, that may lie in the image.
/// The source is a model, and the scorer outlives the edges.
[[nodiscard]] std::vector<LensEdge> lens_edges(const Scorer& scorer);

/// Scored points at so many azimuths, from 0 on; those outside the image are points with no verdict but kOutsideLens.
[[nodiscard]] std::vector<Point> points_of(const Scorer& scorer, const LensEdge& edge, int azimuths);

}  // namespace fca::internal
