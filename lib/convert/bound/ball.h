// SPDX-License-Identifier: BSD-3-Clause
// Ball arithmetic. A ball contains a number that is known to lie within `rad` of `mid`. Balls are as rigorous as intervals and
// faster: a product is a few multiplications without a comparison (Rump 1999, "Fast and parallel interval arithmetic", in its
// midpoint-radius form).
//
// Every operation adds one unit in the last place of its midpoint to the radius; the rounding error is at most half of that. It
// then enlarges the radius by more than the rounding errors of the radius itself. With an infinite or NaN radius, nothing is
// known about the number. Comparisons must be written so that they are false for NaN.
#pragma once

#include <cmath>
#include <limits>

namespace fca::internal {

/// The numbers from mid - rad to mid + rad.
struct Ball {
  double mid = 0.0;
  double rad = 0.0;

  /// The largest absolute value in the ball.
  [[nodiscard]] double magnitude() const { return std::abs(mid) + rad; }
};

/// An upper bound of the relative rounding error of one operation (twice the unit roundoff).
inline constexpr double kRoundOff = std::numeric_limits<double>::epsilon();
/// An upper bound of the factor by which rounding makes a radius too small.
inline constexpr double kRadiusGrowth = 1.0 + 16.0 * kRoundOff;
/// An upper bound of the error of one operation by underflow.
inline constexpr double kUnderflow = 1e-300;

/// The ball around `mid` with the radius `rad` plus the rounding error of `mid`.
inline Ball rounded(double mid, double rad) { return {mid, (rad + kRoundOff * std::abs(mid) + kUnderflow) * kRadiusGrowth}; }

/// The ball of all numbers.
inline Ball unknown() { return {0.0, std::numeric_limits<double>::infinity()}; }

/// The ball around a result of the mathematical library, which may be wrong by four units in the last place. `rad`: its other
/// errors.
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

/// sqrt(b); unknown if b may be 0 or negative. (At 0, its derivative does not exist.)
inline Ball sqrt(const Ball& b) {
  if (!(b.mid * (1.0 - 4.0 * kRoundOff) > b.rad)) return unknown();
  const double root = std::sqrt(b.mid);
  return rounded(root, b.rad / root * kRadiusGrowth);  // |sqrt(x) - sqrt(m)| = |x - m| / (sqrt(x) + sqrt(m))
}

inline Ball sin(const Ball& b) { return from_library(std::sin(b.mid), b.rad + kRoundOff); }
inline Ball cos(const Ball& b) { return from_library(std::cos(b.mid), b.rad + kRoundOff); }

/// A sum of products. Its radius is enlarged only once, in ball().
class ProductSum {
 public:
  void add(const Ball& a, const Ball& b) {
    const double product = a.mid * b.mid;
    mid_ += product;
    size_ += std::abs(product);
    rad_ += std::abs(a.mid) * b.rad + a.rad * (std::abs(b.mid) + b.rad);
  }
  /// The sum of up to 16 products. Each product and each partial sum is rounded once, and its absolute value is at most the sum
  /// of the products' absolute values, size_.
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
