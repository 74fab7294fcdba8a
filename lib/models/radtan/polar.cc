// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/radtan.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Radtan::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::Series;
  const Series r = angle.sine / angle.cosine;
  const Series r2 = r * r;
  set_focal(form, p, r * polynomial(std::array{1.0, p[4], p[5], p[8]}, r2));
  add_tangential(form, p, p[6], p[7], r2);
}

}  // namespace fca
