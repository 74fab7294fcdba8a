// SPDX-License-Identifier: BSD-3-Clause
// A straight line in an image.
#pragma once

#include <fca/models/camera_model.h>

#include <cmath>

namespace fca::internal {

/// A straight line between two pixels. A place on it is a fraction of its length: 0 at `from`, 1 at `to`.
struct Line {
  Pixel from;
  Pixel to;
  /// The pixel at the place t.
  [[nodiscard]] Pixel at(double t) const { return {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}; }
  /// The length [px].
  [[nodiscard]] double length() const { return std::hypot(to[0] - from[0], to[1] - from[1]); }
};

}  // namespace fca::internal
