// SPDX-License-Identifier: BSD-3-Clause
// A model's polar form (polar.h) over a strip of angles: polynomials with plain doubles as coefficients, and rigorous bounds of
// how far the pixel can be from them.
#pragma once

#include "polar.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace fca::internal {

using Polynomial = std::array<double, kOrder>;

/// A pixel as a function of angle and azimuth, over a strip of angles. For each image component and each harmonic of the
/// azimuth there is a polynomial in t, the angle [rad] from the strip's centre. `remainder`: how far each component [px] may be
/// from the sum of these, anywhere in the strip.
template <std::size_t N>
struct Field {
  std::array<std::array<Polynomial, N>, 2> of{};
  /// Upper bound of the absolute third derivative of each polynomial in the strip.
  std::array<std::array<double, N>, 2> third{};
  /// Number of coefficients of each polynomial up to the last that is not 0.
  std::array<std::array<std::size_t, N>, 2> terms{};
  std::array<double, 2> remainder{};
  /// The part of the remainder that is smaller on a narrower strip; the rest is rounding. Sum of both components [px].
  double truncation = 0.0;
};

/// The number of coefficients of a polynomial up to the last that is not 0.
inline std::size_t terms_of(const Polynomial& polynomial) {
  std::size_t terms = polynomial.size();
  while (terms > 0 && polynomial[terms - 1] == 0.0) --terms;
  return terms;
}

/// `centre`: the Taylor series at the strip's centre, whose coefficients become the polynomials. `strip`: the series with the
/// whole strip as its centre (a ball); its last coefficient gives Lagrange's remainder, and its first one encloses the function
/// over the strip. Where the remainder is infinite or larger than that enclosure, the polynomial is a constant and the
/// enclosure its error.
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
