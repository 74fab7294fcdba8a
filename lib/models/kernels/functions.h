// SPDX-License-Identifier: BSD-3-Clause
// Elementary functions without branches or calls, of which a compiler makes SIMD loops. Their absolute errors are a few units
// of 1e-16.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace fca::internal {

/// 1, -1 / 3!, 1 / 5!, ... (first = 1) or 1, -1 / 2!, 1 / 4!, ... (first = 0): the sine's or the cosine's Taylor coefficients.
template <std::size_t N>
constexpr std::array<double, N> alternating_inverse_factorials(int first) {
  std::array<double, N> result{};
  double term = 1.0;
  for (std::size_t k = 0; k < N; ++k) {
    result[k] = term;
    const int last = first + 2 * static_cast<int>(k);
    term /= -static_cast<double>((last + 1) * (last + 2));
  }
  return result;
}

/// 1, -1 / 3, 1 / 5, ...: those of the arc tangent.
template <std::size_t N>
constexpr std::array<double, N> alternating_inverse_odds() {
  std::array<double, N> result{};
  for (std::size_t k = 0; k < N; ++k) result[k] = (k % 2 == 0 ? 1.0 : -1.0) / (2.0 * static_cast<double>(k) + 1.0);
  return result;
}

/// Calls f that many times, without a loop: a loop within a loop is no SIMD.
template <int Times, class F>
inline void repeat(const F& f) {
  if constexpr (Times > 0) {
    f();
    repeat<Times - 1>(f);
  }
}

template <std::size_t N>
inline double horner(const std::array<double, N>& coefficients, double x) {
  double value = coefficients[N - 1];
  std::size_t k = N - 1;
  repeat<static_cast<int>(N) - 1>([&] { value = value * x + coefficients[--k]; });
  return value;
}

struct SineCosine {
  double sine;
  double cosine;
};

/// Of an angle in [0, pi], by half of it: (pi / 2)^24 / 24! < 1e-19.
inline SineCosine sine_cosine(double angle) {
  constexpr auto kSine = alternating_inverse_factorials<12>(1);
  constexpr auto kCosine = alternating_inverse_factorials<12>(0);
  const double half = 0.5 * angle;
  const double square = half * half;
  const double sine = half * horner(kSine, square);
  const double cosine = horner(kCosine, square);
  return {2.0 * sine * cosine, 1.0 - 2.0 * sine * sine};
}

/// atan2(y, x) for y >= 0, by a quarter of the angle from the x axis, whose tangent is at most tan(pi / 8): tan(pi / 8)^40 / 41
/// < 2e-17.
inline double angle_of(double x, double y) {
  constexpr auto kArcTangent = alternating_inverse_odds<20>();
  const double half = y / (std::sqrt(x * x + y * y) + std::abs(x));
  const double quarter = half / (1.0 + std::sqrt(1.0 + half * half));
  const double angle = 4.0 * quarter * horner(kArcTangent, quarter * quarter);
  return x >= 0.0 ? angle : std::numbers::pi - angle;
}

/// The polynomial through the values of a smooth function at the Chebyshev points of [0, upper] (in Newton's form): where
/// Newton's method starts to invert a lens.
class Interpolant {
 public:
  Interpolant() = default;
  template <class F>
  Interpolant(double upper, const F& f) {
    for (std::size_t k = 0; k < kPoints; ++k) {
      const double turn = std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(kPoints);
      points_[k] = 0.5 * upper * (1.0 - std::cos(turn));
      differences_[k] = f(points_[k]);
    }
    for (std::size_t order = 1; order < kPoints; ++order) {
      for (std::size_t k = kPoints - 1; k >= order; --k)
        differences_[k] = (differences_[k] - differences_[k - 1]) / (points_[k] - points_[k - order]);
    }
  }

  double operator()(double x) const {
    double value = differences_[kPoints - 1];
    for (std::size_t k = kPoints - 1; k-- > 0;) value = value * (x - points_[k]) + differences_[k];
    return value;
  }

 private:
  static constexpr std::size_t kPoints = 12;
  std::array<double, kPoints> points_{};
  std::array<double, kPoints> differences_{};
};

}  // namespace fca::internal
