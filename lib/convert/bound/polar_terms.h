// SPDX-License-Identifier: BSD-3-Clause
// Terms from which the models' polar forms are built.
#pragma once

#include "polar.h"

#include <array>
#include <cstddef>

namespace fca::internal {

inline Ball exactly(double value) { return {value, 0.0}; }

/// Sets centre + A (cos phi, sin phi) R; `a` is A, row-major.
void set_radial(PolarSeries& form, const std::array<double, 2>& centre, const std::array<double, 4>& a, const Series& radius);
/// set_radial() for p = fx fy cx cy.
void set_focal(PolarSeries& form, const double* p, const Series& radius);

/// Adds the tangential distortion p1, p2; r2 is the squared distance of a point from the centre of the normalised image plane,
/// p = fx fy cx cy.
void add_tangential(PolarSeries& form, const double* p, double p1, double p2, const Series& r2);
/// Adds thin prism distortion, which moves that point by (u[0] + u[1] r2, v[0] + v[1] r2) r2.
void add_prism(PolarSeries& form, const double* p, const std::array<double, 2>& u, const std::array<double, 2>& v,
               const Series& r2);

/// The image radius of the unified models for a unit ray: sine / (a d + (1 - a) z).
inline Series unified_radius(const Ball& a, const Series& d, const Series& z, const Series& sine) {
  return sine / (a * d + (exactly(1.0) - a) * z);
}

/// theta (a_0 + a_1 theta + ...), by multiplications with the variable theta.
template <std::size_t N>
Series polynomial_of_angle(const std::array<double, N>& coefficients, const Ball& angle) {
  Series result = constant(exactly(coefficients[N - 1]));
  for (std::size_t k = N - 1; k-- > 0;) result = exactly(coefficients[k]) + times_variable(result, angle);
  return times_variable(result, angle);
}

}  // namespace fca::internal
