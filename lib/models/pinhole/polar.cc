// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/pinhole.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Pinhole::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  set_focal(form, p, angle.sine / angle.cosine);
}

}  // namespace fca
