// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/fisheye624.h>

#include "../../convert/bound/polar_terms.h"

#include <array>

namespace fca {

void Fisheye624::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::Series;
  const std::array coefficients = {1.0, 0.0, p[4], 0.0, p[5], 0.0, p[6], 0.0, p[7], 0.0, p[8], 0.0, p[9]};
  const Series radius = polynomial_of_angle(coefficients, angle.at);
  const Series radius2 = radius * radius;
  set_focal(form, p, radius);
  const auto [unused0, unused1, p1, p2, s0, s1, s2, s3] = further_terms(p);
  add_tangential(form, p, p1, p2, radius2);
  add_prism(form, p, {s0, s1}, {s2, s3}, radius2);
}

}  // namespace fca
