// SPDX-License-Identifier: BSD-3-Clause
// A model's polar form (polar.h) over a strip of angles: polynomials with doubles as coefficients, and rigorous bounds of the
// distance between the pixel and these polynomials.
#pragma once

#include "polar.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace fca::internal {

/// The coefficients of a polynomial; the coefficient of t^k has the index k.
using Polynomial = std::array<double, kOrder>;

/// A pixel (or a difference of two pixels) as a function of angle and azimuth, over a strip of angles. Component i of the pixel
/// is the sum over j of the polynomial of[i][j] in t, the difference [rad] of the angle to that of the strip's centre, times
/// harmonic j of the azimuth.
template <std::size_t N>
struct Field {
  std::array<std::array<Polynomial, N>, 2> of{};
  /// An upper bound of the absolute third derivative of each polynomial in the strip.
  std::array<std::array<double, N>, 2> third{};
  /// The number of coefficients of each polynomial up to the last one that is not 0.
  std::array<std::array<std::size_t, N>, 2> terms{};
  /// An upper bound, for the whole strip, of the distance [px] of each component from its sum of polynomials.
  std::array<double, 2> remainder{};
  /// The part of the remainder that becomes smaller on a narrower strip: all of it except rounding errors. The sum of both
  /// components [px].
  double truncation = 0.0;
};

/// The number of coefficients of a polynomial up to the last one that is not 0.
inline std::size_t terms_of(const Polynomial& polynomial) {
  std::size_t terms = polynomial.size();
  while (terms > 0 && polynomial[terms - 1] == 0.0) --terms;
  return terms;
}

/// The field of a pixel over a strip. `centre`: the Taylor series at the strip's centre, whose coefficients become those of the
/// polynomials. `strip`: the series whose centre is the whole strip, as a ball. Its last coefficient bounds the remainder
/// (Lagrange), and its first one is a ball with all values in the strip. If the remainder is infinite or larger than the radius
/// of that ball, the polynomial is the ball's midpoint instead and its remainder the ball's radius. `half`: half of the strip's
/// width [rad].
template <std::size_t N>
Field<N> field_of(const PolarSeriesOf<N>& centre, const PolarSeriesOf<N>& strip, double half) {
  Field<N> field;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      if (!centre.used[i][j]) continue;
      const Series& point = centre.of[i][j];
      Polynomial& polynomial = field.of[i][j];
      double power = 1.0;
      double remainder = 0.0;
      double size = 0.0;
      for (std::size_t k = 0; k < kOrder; ++k, power *= half) {
        polynomial[k] = point[k].mid;
        remainder += point[k].rad * power;
        size += std::abs(point[k].mid) * power;
      }
      double truncation = strip.of[i][j][kOrder].magnitude() * power;
      remainder += truncation;
      // Allows for later sums in plain doubles: fewer than 64 roundings of numbers of at most `size`.
      constexpr double kRoundings = 64.0;
      remainder = remainder * (1.0 + 1e-12) + kRoundings * kRoundOff * size;
      const Ball& plain = strip.of[i][j][0];
      if (!(remainder <= plain.rad)) {
        polynomial = {plain.mid};
        truncation = plain.rad;
        remainder = plain.rad + kRoundings * kRoundOff * std::abs(plain.mid);
      }
      field.remainder[i] += remainder;
      field.truncation += truncation;
      field.terms[i][j] = terms_of(polynomial);
      double third = 0.0;
      for (std::size_t k = kOrder - 1; k >= 3; --k) {
        third = third * half + static_cast<double>(k * (k - 1) * (k - 2)) * std::abs(polynomial[k]);
      }
      field.third[i][j] = third;
    }
    field.remainder[i] += strip.series_rest_px[i];
  }
  return field;
}

}  // namespace fca::internal
