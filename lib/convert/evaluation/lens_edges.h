// SPDX-License-Identifier: BSD-3-Clause
// The edges of the scored region that lie inside an image. Errors are often largest there. An edge has no area, so that a
// lattice has few points on it.
#pragma once

#include "scorer.h"

#include <functional>
#include <optional>
#include <vector>

namespace fca::internal {

/// A curve in the image at which the scored region ends.
struct LensEdge {
  /// The edge's pixel at an azimuth [rad] about the axis, slightly inside the scored region; nullopt if that pixel lies outside
  /// the image.
  std::function<std::optional<Pixel>(double azimuth)> at;
  /// True if a scored point lies on this edge, or as near to it as the points that a lattice has at edges.
  std::function<bool(const Point& point)> passes;
};

/// The edges that may lie in the image. One is at the largest scored angle: the smallest of the field of view's, the target's
/// and the models' maximum angles. Another one is the rim of the field of view's circle, if it has a circle. The scorer's
/// source must be a model. The edges refer to the scorer, which must outlive them.
[[nodiscard]] std::vector<LensEdge> lens_edges(const Scorer& scorer);

/// Evaluates points of the edge at `azimuths` equally spaced azimuths, the first at 0. A point outside the image only has a
/// verdict, kOutsideLens.
[[nodiscard]] std::vector<Point> points_of(const Scorer& scorer, const LensEdge& edge, int azimuths);

}  // namespace fca::internal
