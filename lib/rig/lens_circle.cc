// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/lens_circle.h>

#include <cmath>

namespace fca {

bool LensCircle::contains(const Pixel& pixel) const {
  return std::hypot(pixel[0] - centre[0], pixel[1] - centre[1]) <= radius_px;
}

}  // namespace fca
