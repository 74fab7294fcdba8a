// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/division.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Division::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::Ball;
  using internal::exactly;
  using internal::Series;
  if (p[4] == 0.0) return set_focal(form, p, angle.sine / angle.cosine);
  // R = 2 sin / (cos + d), d^2 = cos^2 - 4 k sin^2 = (1 + 4 k) cos^2 - 4 k
  const Ball four_k = exactly(4.0) * exactly(p[4]);
  const Series d = sqrt(exactly(-1.0) * four_k + (exactly(1.0) + four_k) * (angle.cosine * angle.cosine));
  if (angle.cosine[0].mid > 0.0) return set_focal(form, p, exactly(2.0) * angle.sine / (angle.cosine + d));
  const Ball two_k = exactly(2.0) * exactly(p[4]);
  set_focal(form, p, (angle.cosine - d) / (two_k * angle.sine));
}

}  // namespace fca
