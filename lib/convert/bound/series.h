// SPDX-License-Identifier: BSD-3-Clause
// Taylor series whose coefficients are balls: f(centre + t) = c_0 + c_1 t + ... + c_n t^n + ... The coefficients follow from
// the recurrences of automatic differentiation of higher order (Moore 1966, "Interval Analysis", ch. 11).
//
// If the centre is a point, the coefficients are those of f's Taylor polynomial there. If the centre is a ball with a radius,
// c_n contains f^(n)(x) / n! for every x in the centre. c_n then bounds Lagrange's remainder of the polynomial of degree n - 1,
// so that both series together bound f on the ball.
#pragma once

#include "ball.h"

#include <array>
#include <cstddef>

namespace fca::internal {

/// The order n of the remainder. For a remainder of 1e-9 px, the width of a strip may be about (1e-9 / 500)^(1 / n) of the
/// distance to the nearest singularity of the lens.
inline constexpr std::size_t kOrder = 10;

/// The coefficients c_0 to c_n, with n = kOrder.
struct Series {
  std::array<Ball, kOrder + 1> c{};
  Ball& operator[](std::size_t k) { return c[k]; }
  const Ball& operator[](std::size_t k) const { return c[k]; }
};

/// The series of a constant function.
inline Series constant(const Ball& value) {
  Series result;
  result[0] = value;
  return result;
}

inline Series operator+(const Series& a, const Series& b) {
  Series result;
  for (std::size_t k = 0; k <= kOrder; ++k) result[k] = a[k] + b[k];
  return result;
}
inline Series operator-(const Series& a, const Series& b) {
  Series result;
  for (std::size_t k = 0; k <= kOrder; ++k) result[k] = a[k] - b[k];
  return result;
}
inline Series operator*(const Ball& a, const Series& b) {
  Series result;
  for (std::size_t k = 0; k <= kOrder; ++k) result[k] = a * b[k];
  return result;
}
inline Series operator+(const Ball& a, Series b) {
  b[0] = a + b[0];
  return b;
}

inline Series operator*(const Series& a, const Series& b) {
  Series result;
  for (std::size_t k = 0; k <= kOrder; ++k) {
    ProductSum sum;
    for (std::size_t j = 0; j <= k; ++j) sum.add(a[j], b[k - j]);
    result[k] = sum.ball();
  }
  return result;
}

/// The product of a and the variable x0 + t itself. It is faster than a product of two series.
inline Series times_variable(const Series& a, const Ball& x0) {
  Series result;
  result[0] = a[0] * x0;
  for (std::size_t k = 1; k <= kOrder; ++k) result[k] = a[k] * x0 + a[k - 1];
  return result;
}

inline Series operator/(const Series& a, const Series& b) {
  const Ball scale = inverse(b[0]);
  Series result;
  for (std::size_t k = 0; k <= kOrder; ++k) {
    ProductSum sum;
    for (std::size_t j = 1; j <= k; ++j) sum.add(b[j], result[k - j]);
    result[k] = (a[k] - sum.ball()) * scale;
  }
  return result;
}

inline Series sqrt(const Series& a) {
  Series result;
  result[0] = sqrt(a[0]);
  const Ball scale = inverse(Ball{2.0, 0.0} * result[0]);
  for (std::size_t k = 1; k <= kOrder; ++k) {
    ProductSum sum;
    for (std::size_t j = 1; j < k; ++j) sum.add(result[j], result[k - j]);
    result[k] = (a[k] - sum.ball()) * scale;
  }
  return result;
}

/// The series of the function with this derivative and with this value at the centre.
inline Series integral(const Series& derivative, const Ball& value) {
  Series result;
  result[0] = value;
  for (std::size_t k = 1; k <= kOrder; ++k) result[k] = derivative[k - 1] / Ball{static_cast<double>(k), 0.0};
  return result;
}

/// The sum of coefficients[k] x^k (Horner).
template <std::size_t N>
Series polynomial(const std::array<double, N>& coefficients, const Series& x) {
  Series result = constant({coefficients[N - 1], 0.0});
  for (std::size_t k = N - 1; k-- > 0;) result = Ball{coefficients[k], 0.0} + result * x;
  return result;
}

/// The angle from the axis as the variable of series, with its sine and cosine.
struct AngleSeries {
  Ball at;  ///< The centre of the series [rad].
  Series sine;
  Series cosine;
};

/// The series with this centre [rad].
inline AngleSeries angle_series(const Ball& at) {
  AngleSeries angle{at, {}, {}};
  const Ball sine = sin(at);
  const Ball cosine = cos(at);
  Ball inverse_factorial{1.0, 0.0};
  for (std::size_t k = 0; k <= kOrder; ++k) {
    if (k > 0) inverse_factorial = inverse_factorial / Ball{static_cast<double>(k), 0.0};
    const Ball& s = k % 2 == 0 ? sine : cosine;  // sin, cos, -sin, -cos
    const Ball& c = k % 2 == 0 ? cosine : sine;  // cos, -sin, -cos, sin
    const Ball s_sign{k % 4 < 2 ? 1.0 : -1.0, 0.0};
    const Ball c_sign{k % 4 == 0 || k % 4 == 3 ? 1.0 : -1.0, 0.0};
    angle.sine[k] = s_sign * s * inverse_factorial;
    angle.cosine[k] = c_sign * c * inverse_factorial;
  }
  return angle;
}

}  // namespace fca::internal
