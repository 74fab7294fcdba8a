// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace fca::internal {

/// Rays of a model whose image radius is a polynomial of the angle from the axis: radius = angle (c[0] + c[1] x + ...) with
/// x = angle^kPower (kb4: 2, woodscape: 1). The angle comes from an interpolated start and two Newton steps, without a branch,
/// so that the compiler makes SIMD of it. Where that is not accurate, the ray asks the caller to use the model itself
/// (ask_unless). `lens`, `model`: angles [rad] at which the lens and the model end.
template <std::size_t N, int kPower>
class PolynomialAngle {
 public:
  PolynomialAngle(const std::array<double, N>& c, double lens, double model)
      : c_(c), none_beyond_(kSurelyOutside * radius(std::min(lens, model)) + kRadiusSlack), largest_(kSurelyInside * model) {
    for (std::size_t k = 0; k < N; ++k) derivative_[k] = (1.0 + kPower * static_cast<double>(k)) * c[k];
    const double smooth = std::min(lens, kSmooth * model);
    const double end = radius(smooth);
    start_ = Interpolant(kPower == 2 ? end * end : end, [&](double x) {
      const double at = kPower == 2 ? std::sqrt(x) : x;
      const auto f = [this](double angle, double& value, double& derivative) {
        value = radius(angle);
        derivative = horner(derivative_, power(angle));
      };
      double angle = smooth * at / end;
      return invert_increasing(f, at, smooth, angle) ? angle / at : kAskModel;
    });
  }

  /// The unit ray in the direction of (x, y), whose length is the radius.
  [[nodiscard]] UnitRay ray(double x, double y) const {
    const double r2 = x * x + y * y + kTiny;
    const double r = std::sqrt(r2);
    double angle = r * start_(kPower == 2 ? r2 : r);
    double step = 0.0;
    repeat<kSteps>([&] {
      const double t = power(angle);
      step = (angle * horner(c_, t) - r) / horner(derivative_, t);
      angle -= step;
    });
    const SineCosine of_angle = sine_cosine(angle);
    const double scale = of_angle.sine / r;
    const double z = of_angle.cosine + ask_unless(std::abs(step) <= kLastStep * angle) + ask_unless(angle < largest_);
    return {scale * x, scale * y, r > none_beyond_ ? kNoRay : z};
  }

 private:
  static constexpr int kSteps = 2;
  static double power(double angle) { return kPower == 2 ? angle * angle : angle; }
  [[nodiscard]] double radius(double angle) const { return angle * horner(c_, power(angle)); }

  std::array<double, N> c_;
  std::array<double, N> derivative_{};
  Interpolant start_;
  double none_beyond_;
  double largest_;
};

}  // namespace fca::internal
