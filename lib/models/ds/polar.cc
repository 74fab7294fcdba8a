// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ds.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Ds::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::Ball;
  using internal::exactly;
  using internal::Series;
  const Ball xi = exactly(p[5]);
  // d2^2 = sin^2 + (xi + cos)^2 = 1 + xi^2 + 2 xi cos
  const Series d2 = sqrt((exactly(1.0) + xi * xi) + (exactly(2.0) * xi) * angle.cosine);
  set_focal(form, p, unified_radius(exactly(p[4]), d2, xi + angle.cosine, angle.sine));
}

}  // namespace fca
