// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rays.h"

#include <fca/models/radial_tangential.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fca::internal {

/// The inverse of TangentialOver<Factor>. `lens` and `smooth`: radii where the lens ends, and where the inverse is still
/// smooth.
template <class Factor>
class TangentialInverse {
 public:
  struct Point {
    double x;
    double y;
    double r2;
    double doubt;   ///< To be added to the ray's z.
    double beyond;  ///< Positive where there is surely no such point within the lens.
  };

  TangentialInverse(const double* q, double lens, double smooth) {
    std::copy_n(q, Factor::kCount, q_.data());
    const double largest = kSurelyInside * TangentialOver<Factor>::max_radius(q);
    largest_square_ = largest * largest;
    const auto radial = [this](double r, double& value, double& derivative) {
      Factor::factor_and_derivative(q_.data(), r * r, value, derivative);
      derivative = value + 2.0 * r * r * derivative;
      value *= r;
    };
    double none_beyond = 0.0;
    double end = 0.0;
    double derivative = 0.0;
    radial(lens, none_beyond, derivative);
    none_beyond = kSurelyOutside * (none_beyond + 3.0 * length(q[2], q[3]) * lens * lens) + kRadiusSlack;
    none_beyond_square_ = std::isfinite(none_beyond) ? none_beyond * none_beyond : kAskModel;
    radial(smooth, end, derivative);
    start_ = Interpolant(end * end, [&](double square) {
      const double at = std::sqrt(square);
      double r = smooth * at / end;
      return invert_increasing(radial, at, smooth, r) ? r / at : kAskModel;
    });
  }

  /// The (x, y) of a distorted (mx, my): Newton's method from the inverse without tangential terms.
  [[nodiscard]] Point operator()(double mx, double my) const {
    const double square = mx * mx + my * my;
    const double scale = start_(square);
    double x = mx * scale;
    double y = my * scale;
    double step = 0.0;
    const double p1 = q_[2];
    const double p2 = q_[3];
    repeat<kSteps>([&] {
      const double r2 = x * x + y * y;
      double radial = 0.0;
      double derivative = 0.0;
      Factor::factor_and_derivative(q_.data(), r2, radial, derivative);
      const double xy2 = 2.0 * x * y;
      const double ex = x * radial + p1 * xy2 + p2 * (r2 + 2.0 * x * x) - mx;
      const double ey = y * radial + p1 * (r2 + 2.0 * y * y) + p2 * xy2 - my;
      const double xx = radial + 2.0 * (x * x * derivative + p1 * y) + 6.0 * p2 * x;
      const double yy = radial + 2.0 * (y * y * derivative + p2 * x) + 6.0 * p1 * y;
      const double across = xy2 * derivative + 2.0 * (p1 * x + p2 * y);
      const double inverse = 1.0 / (xx * yy - across * across);
      const double dx = (yy * ex - across * ey) * inverse;
      const double dy = (xx * ey - across * ex) * inverse;
      step = dx * dx + dy * dy;
      x -= dx;
      y -= dy;
    });
    const double r2 = x * x + y * y;
    const double doubt = ask_unless(step <= kLastStep * kLastStep * r2 + kTiny) + ask_unless(r2 < largest_square_);
    return {x, y, r2, doubt, square - none_beyond_square_};
  }

 private:
  static constexpr int kSteps = 3;
  std::array<double, Factor::kCount> q_{};
  Interpolant start_;
  double largest_square_ = 0.0;
  double none_beyond_square_ = 0.0;
};

template <class M, class Factor>
struct PerspectiveRays {
  PixelToPlane plane;
  TangentialInverse<Factor> inverse;
  PerspectiveRays(const double* p, double lens)
      : plane(p),
        inverse(p + 4, std::tan(std::min(lens, M::max_angle(p))), std::tan(std::min(lens, kSmooth * M::max_angle(p)))) {}
  UnitRay operator()(double u, double v) const {
    const auto point = inverse(plane.x(u), plane.y(v));
    const UnitRay ray = normalised(point.x, point.y, 1.0, point.doubt);
    return {ray.x, ray.y, point.beyond > 0.0 ? kNoRay : ray.z};
  }
};
}  // namespace fca::internal
