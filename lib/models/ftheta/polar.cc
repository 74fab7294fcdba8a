// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ftheta.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Ftheta::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  set_radial(form, {p[kCx], p[kCy]}, {p[kC], p[kD], p[kE], 1.0},
             polynomial_of_angle(std::array{p[0], p[1], p[2], p[3], p[4]}, angle.at));
}

}  // namespace fca
