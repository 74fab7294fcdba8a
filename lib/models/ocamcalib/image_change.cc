// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ocamcalib.h>

#include <fca/rig/image_change.h>

namespace fca {

/// rho grows with u, so that f(rho) / rho, the angle, stays: a'_k = a_k s^(1 - k), s along u. v takes the rest: c and d.
void Ocamcalib::map_pixels(double* p, const PixelMap& map) {
  const auto [scale_u, scale_v] = map.scale;
  const Pixel centre = map({p[0], p[1]});
  p[0] = centre[0];
  p[1] = centre[1];
  p[2] *= scale_v / scale_u;  // c
  p[3] *= scale_v / scale_u;  // d
  double factor = scale_u;
  for (std::size_t k = 5; k < kParameters.size(); ++k, factor /= scale_u) p[k] *= factor;
}

}  // namespace fca
