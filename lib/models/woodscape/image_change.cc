// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/woodscape.h>

#include <fca/rig/image_change.h>

namespace fca {

/// rho is in pixels of u; the ratio of v to u has a parameter of its own.
void Woodscape::map_pixels(double* p, const PixelMap& map) {
  for (std::size_t k = 0; k < 4; ++k) p[k] *= map.scale[0];
  p[4] *= map.scale[1] / map.scale[0];
  const Pixel centre = map({p[5], p[6]});
  p[5] = centre[0];
  p[6] = centre[1];
}

}  // namespace fca
