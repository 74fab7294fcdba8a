// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/thin_prism_fisheye.h>

#include "../../convert/bound/polar_terms.h"

#include <array>

namespace fca {

void ThinPrismFisheye::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::exactly;
  using internal::Series;
  const Series theta = times_variable(constant(exactly(1.0)), angle.at);
  const Series theta2 = theta * theta;
  set_focal(form, p, polynomial_of_angle(std::array{1.0, 0.0, p[4], 0.0, p[5], 0.0, p[8], 0.0, p[9]}, angle.at));
  add_tangential(form, p, p[6], p[7], theta2);
  add_prism(form, p, std::array{p[10], 0.0}, std::array{p[11], 0.0}, theta2);
}

}  // namespace fca
