// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/mei.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Mei::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::exactly;
  using internal::Series;
  const Series r = angle.sine / (exactly(p[4]) + angle.cosine);
  const Series r2 = r * r;
  set_focal(form, p, r * polynomial(std::array{1.0, p[5], p[6]}, r2));
  add_tangential(form, p, p[7], p[8], r2);
}

}  // namespace fca
