// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/kb4.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Kb4::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  set_focal(form, p, polynomial_of_angle(std::array{1.0, 0.0, p[4], 0.0, p[5], 0.0, p[6], 0.0, p[7]}, angle.at));
}

}  // namespace fca
