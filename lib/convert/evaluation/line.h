// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <cmath>

namespace fca::internal {

/// A straight line between two pixels. A place on it is a fraction of its length: 0 at `from`, 1 at `to`.
struct Line {
  Pixel from;
  Pixel to;
  [[nodiscard]] Pixel at(double t) const { return {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}; }
  [[nodiscard]] double length() const { return std::hypot(to[0] - from[0], to[1] - from[1]); }
};

}  // namespace fca::internal
