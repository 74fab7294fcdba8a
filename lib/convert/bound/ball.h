// SPDX-License-Identifier: BSD-3-Clause
// Ball arithmetic: a number known to lie within `rad` of `mid`. As rigorous as intervals, and cheaper: a product is a few
// multiplications without a comparison (Rump 1999, "Fast and parallel interval arithmetic", in its midpoint-radius form).
//
// Every operation adds the rounding error of its midpoint (at most half a unit in the last place; a whole one is added) to the
// radius. It then enlarges the radius by more than the rounding errors of computing it. An infinite or NaN radius means that
// nothing is known. Write comparisons so that they fail for NaN.
#pragma once

#include <cmath>
#include <limits>

namespace fca::internal {

struct Ball {
  double mid = 0.0;
  double rad = 0.0;

  /// The largest absolute value in the ball.
  [[nodiscard]] double magnitude() const { return std::abs(mid) + rad; }
};

/// Upper bounds: of the relative rounding error of one operation (twice the unit roundoff), of the factor by which rounding
/// changes a radius, and of what underflow loses.
inline constexpr double kRoundOff = std::numeric_limits<double>::epsilon();
inline constexpr double kRadiusGrowth = 1.0 + 16.0 * kRoundOff;
inline constexpr double kUnderflow = 1e-300;

/// The ball around `mid` with the radius `rad` plus the rounding error of `mid`.
inline Ball rounded(double mid, double rad) { return {mid, (rad + kRoundOff * std::abs(mid) + kUnderflow) * kRadiusGrowth}; }

/// A number of which nothing is known.
inline Ball unknown() { return {0.0, std::numeric_limits<double>::infinity()}; }

/// A result of the mathematical library, which may be wrong by four units in the last place.
inline Ball from_library(double value, double rad = 0.0) {
  constexpr double kUnits = 4.0;
  return {value, (rad + kUnits * kRoundOff * std::abs(value) + kUnderflow) * kRadiusGrowth};
}

inline Ball operator+(const Ball& a, const Ball& b) { return rounded(a.mid + b.mid, a.rad + b.rad); }
inline Ball operator-(const Ball& a, const Ball& b) { return rounded(a.mid - b.mid, a.rad + b.rad); }
inline Ball operator*(const Ball& a, const Ball& b) {
  return rounded(a.mid * b.mid, std::abs(a.mid) * b.rad + a.rad * (std::abs(b.mid) + b.rad));
}

/// 1 / b; unknown if b may be 0.
inline Ball inverse(const Ball& b) {
  const double smallest = (std::abs(b.mid) - b.rad) * (1.0 - 4.0 * kRoundOff);
  if (!(smallest > 0.0)) return unknown();
  return rounded(1.0 / b.mid, b.rad / (std::abs(b.mid) * smallest) * kRadiusGrowth);
}
inline Ball operator/(const Ball& a, const Ball& b) { return a * inverse(b); }

/// sqrt(b); unknown if b may be 0 or negative, since its derivative is unknown there too.
inline Ball sqrt(const Ball& b) {
  if (!(b.mid * (1.0 - 4.0 * kRoundOff) > b.rad)) return unknown();
  const double root = std::sqrt(b.mid);
  return rounded(root, b.rad / root * kRadiusGrowth);  // |sqrt(x) - sqrt(m)| = |x - m| / (sqrt(x) + sqrt(m))
}

inline Ball sin(const Ball& b) { return from_library(std::sin(b.mid), b.rad + kRoundOff); }
inline Ball cos(const Ball& b) { return from_library(std::cos(b.mid), b.rad + kRoundOff); }

/// A sum of products, whose radius is enlarged only once.
class ProductSum {
 public:
  void add(const Ball& a, const Ball& b) {
    const double product = a.mid * b.mid;
    mid_ += product;
    size_ += std::abs(product);
    rad_ += std::abs(a.mid) * b.rad + a.rad * (std::abs(b.mid) + b.rad);
  }
  /// Valid for up to 16 products: each product and each partial sum is rounded once, and none is larger than the sum of the
  /// absolute products.
  [[nodiscard]] Ball ball() const {
    constexpr double kRoundings = 32.0;
    return {mid_, (rad_ + kRoundings * kRoundOff * size_ + kUnderflow) * (1.0 + 64.0 * kRoundOff)};
  }

 private:
  double mid_ = 0.0;
  double size_ = 0.0;
  double rad_ = 0.0;
};

}  // namespace fca::internal
