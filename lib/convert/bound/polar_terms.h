// SPDX-License-Identifier: BSD-3-Clause
// The terms that the models' polar forms (polar.h) consist of. `p` is an array that begins with fx, fy, cx, cy.
#pragma once

#include "polar.h"

#include <array>
#include <cstddef>

namespace fca::internal {

/// The ball that contains only this number.
inline Ball exactly(double value) { return {value, 0.0}; }

/// Sets the form to centre + A (cos phi, sin phi) R. `a`: the matrix A, row-major. `radius`: R.
void set_radial(PolarSeries& form, const std::array<double, 2>& centre, const std::array<double, 4>& a, const Series& radius);
/// Calls set_radial() with the centre (cx, cy) and the matrix diag(fx, fy).
void set_focal(PolarSeries& form, const double* p, const Series& radius);

/// Adds the tangential distortion with the coefficients p1, p2. `r2`: the squared distance of a point of the normalised image
/// plane from the plane's centre.
void add_tangential(PolarSeries& form, const double* p, double p1, double p2, const Series& r2);
/// Adds thin prism distortion, which moves a point of the normalised image plane by (u[0] + u[1] r2, v[0] + v[1] r2) r2. `r2`:
/// as for add_tangential().
void add_prism(PolarSeries& form, const double* p, const std::array<double, 2>& u, const std::array<double, 2>& v,
               const Series& r2);

/// The image radius of the unified models, sine / (a d + (1 - a) z), for a unit ray with the component z along the axis.
inline Series unified_radius(const Ball& a, const Series& d, const Series& z, const Series& sine) {
  return sine / (a * d + (exactly(1.0) - a) * z);
}

/// theta (a_0 + a_1 theta + ...), where theta is the variable of the series. `angle`: the centre of the series.
template <std::size_t N>
Series polynomial_of_angle(const std::array<double, N>& coefficients, const Ball& angle) {
  Series result = constant(exactly(coefficients[N - 1]));
  for (std::size_t k = N - 1; k-- > 0;) result = exactly(coefficients[k]) + times_variable(result, angle);
  return times_variable(result, angle);
}

}  // namespace fca::internal
