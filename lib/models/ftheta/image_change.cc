// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ftheta.h>

#include <fca/rig/image_change.h>

namespace fca {

/// rho is in pixels of v; along u, c and d have the ratio.
void Ftheta::map_pixels(double* p, const PixelMap& map) {
  const double ratio = map.scale[0] / map.scale[1];
  for (std::size_t i = 0; i < kTerms; ++i) p[i] *= map.scale[1];
  p[kC] *= ratio;
  p[kD] *= ratio;
  const Pixel centre = map({p[kCx], p[kCy]});
  p[kCx] = centre[0];
  p[kCy] = centre[1];
}

}  // namespace fca
