// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/woodscape.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Woodscape::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  set_radial(form, {p[5], p[6]}, {1.0, 0.0, 0.0, p[4]}, polynomial_of_angle(std::array{p[0], p[1], p[2], p[3]}, angle.at));
}

}  // namespace fca
