// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ucm.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Ucm::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::exactly;
  set_focal(form, p, unified_radius(exactly(p[4]), constant(exactly(1.0)), angle.cosine, angle.sine));
}

}  // namespace fca
