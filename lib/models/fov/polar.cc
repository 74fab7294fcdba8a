// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/fov.h>

#include "../../convert/bound/polar_terms.h"

namespace fca {

void Fov::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::Ball;
  using internal::exactly;
  using internal::from_library;
  using internal::kRoundOff;
  using internal::Series;
  const Ball tangent = exactly(2.0) * from_library(std::tan(0.5 * p[4]));
  // d/dangle atan2(k sin, cos) = k / (k^2 sin^2 + cos^2)
  const Series denominator = (tangent * tangent) + (exactly(1.0) - tangent * tangent) * (angle.cosine * angle.cosine);
  const Series derivative = constant(tangent) / denominator;
  const double value = std::atan2(tangent.mid * std::sin(angle.at.mid), std::cos(angle.at.mid));
  // At the centre, and by the largest derivative around it; rounding inside atan2 counts at most like a rotation of the ray.
  constexpr double kRotation = 8.0 * kRoundOff;
  const Ball start = from_library(value, derivative[0].magnitude() * angle.at.rad + kRotation);
  set_focal(form, p, inverse(exactly(p[4])) * integral(derivative, start));
}

}  // namespace fca
