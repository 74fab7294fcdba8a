// SPDX-License-Identifier: BSD-3-Clause
#include "polar_terms.h"

namespace fca::internal {

void set_radial(PolarSeries& form, const std::array<double, 2>& centre, const std::array<double, 4>& a, const Series& radius) {
  for (std::size_t row = 0; row < 2; ++row) {
    form.set(row, 0, constant(exactly(centre[row])));
    for (std::size_t column = 0; column < 2; ++column) {
      const double factor = a[2 * row + column];
      if (factor != 0.0) form.set(row, 1 + column, exactly(factor) * radius);
    }
  }
}

void set_focal(PolarSeries& form, const double* p, const Series& radius) {
  set_radial(form, {p[2], p[3]}, {p[0], 0.0, 0.0, p[1]}, radius);
}

void add_tangential(PolarSeries& form, const double* p, double p1, double p2, const Series& r2) {
  if (p1 == 0.0 && p2 == 0.0) return;
  const Ball fx = exactly(p[0]);
  const Ball fy = exactly(p[1]);
  const Ball two{2.0, 0.0};
  // A point (m_x, m_y) of the normalised plane: m_x = ... + r^2 (2 p2 + p2 cos 2phi + p1 sin 2phi),  m_y = ... + r^2 (2 p1 - p1
  // cos 2phi + p2 sin 2phi)
  form.set(0, 0, form.of[0][0] + two * fx * exactly(p2) * r2);
  form.set(0, 3, fx * exactly(p2) * r2);
  form.set(0, 4, fx * exactly(p1) * r2);
  form.set(1, 0, form.of[1][0] + two * fy * exactly(p1) * r2);
  form.set(1, 3, fy * exactly(-p1) * r2);
  form.set(1, 4, fy * exactly(p2) * r2);
}

void add_prism(PolarSeries& form, const double* p, const std::array<double, 2>& u, const std::array<double, 2>& v,
               const Series& r2) {
  constexpr std::array<double, 2> kNone = {0.0, 0.0};
  if (u == kNone && v == kNone) return;
  form.set(0, 0, form.of[0][0] + exactly(p[0]) * (r2 * polynomial(u, r2)));
  form.set(1, 0, form.of[1][0] + exactly(p[1]) * (r2 * polynomial(v, r2)));
}

}  // namespace fca::internal
