// SPDX-License-Identifier: BSD-3-Clause
// What the models' polar forms are made of.
#pragma once

#include "polar.h"

#include <array>
#include <cstddef>

namespace fca::internal {

inline Ball exactly(double value) { return {value, 0.0}; }

/// centre + A (cos phi, sin phi) R, A row by row.
void set_radial(PolarSeries& form, const std::array<double, 2>& centre, const std::array<double, 4>& a, const Series& radius);
/// The same of p = fx fy cx cy.
void set_focal(PolarSeries& form, const double* p, const Series& radius);

/// Adds the tangential distortion p1, p2 of a point at distance r from the centre of the plane; r2 is its square.
void add_tangential(PolarSeries& form, const double* p, double p1, double p2, const Series& r2);
/// Adds a thin prism, which moves that point by (u[0] + u[1] r2, v[0] + v[1] r2) r2.
void add_prism(PolarSeries& form, const double* p, const std::array<double, 2>& u, const std::array<double, 2>& v,
               const Series& r2);

/// The unified models on the unit sphere: sin / (a d + (1 - a) z).
inline Series unified_radius(const Ball& a, const Series& d, const Series& z, const Series& sine) {
  return sine / (a * d + (exactly(1.0) - a) * z);
}

/// theta (a_0 + a_1 theta + ...), by multiplications with the variable.
template <std::size_t N>
Series polynomial_of_angle(const std::array<double, N>& coefficients, const Ball& angle) {
  Series result = constant(exactly(coefficients[N - 1]));
  for (std::size_t k = N - 1; k-- > 0;) result = exactly(coefficients[k]) + times_variable(result, angle);
  return times_variable(result, angle);
}

}  // namespace fca::internal
