// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/eucm.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Eucm::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::exactly;
  using internal::Series;
  // Without alpha beta counts for nothing, and a fit may leave any number there.
  if (p[4] == 0.0) return set_focal(form, p, angle.sine / angle.cosine);
  // d^2 = beta sin^2 + cos^2 = beta + (1 - beta) cos^2
  const Series d = sqrt(exactly(p[5]) + (exactly(1.0) - exactly(p[5])) * (angle.cosine * angle.cosine));
  set_focal(form, p, unified_radius(exactly(p[4]), d, angle.cosine, angle.sine));
}

}  // namespace fca
