// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/skewed.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

/// Moves the column by the skew times how far the row is from cy, over fy.
template <CameraModelType M>
void Skewed<M>::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::Ball;
  using internal::exactly;
  using internal::kHarmonics;
  using internal::Series;
  M::polar_form(p, angle, form);
  const Ball shear = exactly(p[kSkew]) / exactly(p[1]);
  for (std::size_t j = 0; j < kHarmonics; ++j) {
    if (!form.used[1][j]) continue;
    const Series moved = shear * (j == 0 ? exactly(-p[3]) + form.of[1][j] : form.of[1][j]);
    form.set(0, j, form.used[0][j] ? form.of[0][j] + moved : moved);
  }
  form.series_rest_px[0] += shear.magnitude() * form.series_rest_px[1];
}

template void Skewed<Radtan>::polar_form(const double*, const internal::AngleSeries&, internal::PolarSeries&);
template void Skewed<Rational>::polar_form(const double*, const internal::AngleSeries&, internal::PolarSeries&);
template void Skewed<Opencv14>::polar_form(const double*, const internal::AngleSeries&, internal::PolarSeries&);
template void Skewed<Kb4>::polar_form(const double*, const internal::AngleSeries&, internal::PolarSeries&);
template void Skewed<Mei>::polar_form(const double*, const internal::AngleSeries&, internal::PolarSeries&);

}  // namespace fca
