// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/lens_circle.h>

#include <cmath>

namespace fca {

double LensCircle::beyond(const Pixel& pixel) const {
  return std::hypot(pixel[0] - centre[0], pixel[1] - centre[1]) - radius_px;
}

Pixel LensCircle::rim(double azimuth) const {
  return {centre[0] + radius_px * std::cos(azimuth), centre[1] + radius_px * std::sin(azimuth)};
}

}  // namespace fca
