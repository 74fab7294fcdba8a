// SPDX-License-Identifier: BSD-3-Clause
// Pixel -> unit ray for many pixels of one camera: what a model's unproject() does anew for each pixel is done once (limits,
// and a polynomial from which Newton's method needs few steps), and what remains has neither branches nor calls, so that a
// compiler makes SIMD of a loop over it.
//
// A kernel is right where it answers, and answers nearly everywhere. Where it is not sure, near a model's limit or because
// Newton's method has not ended, it says so, and the caller asks the model. So models need no kernel.
#pragma once

#include "functions.h"

#include <fca/models/camera_model.h>

#include <algorithm>
#include <limits>

namespace fca::internal {

/// Instead of a z: there is surely no ray within the lens. Any other z that is not finite means: ask the model.
inline constexpr double kNoRay = -std::numeric_limits<double>::infinity();
inline constexpr double kAskModel = std::numeric_limits<double>::infinity();

/// The last step of Newton's method, relatively: the next would be about its square.
inline constexpr double kLastStep = 1e-8;
/// Kernels leave to the model what is closer than this to its limit; and further: there no polynomial is near its inverse.
inline constexpr double kSurelyInside = 0.999;
inline constexpr double kSurelyOutside = 1.0 + 1e-9;
/// A domain may be the axis alone, an image of one pixel: no radius below this is surely outside.
inline constexpr double kRadiusSlack = 1e-6;
inline constexpr double kSmooth = 0.97;
/// Added to squares, so that a radius is never 0 and (x, y) / radius is 0 on the axis.
inline constexpr double kTiny = 1e-300;

struct UnitRay {
  double x;
  double y;
  double z;
};

/// Leaves every pixel to the model. Specialisations: RayKernel(p, lens), lens = the angle where the lens ends, beyond which
/// kNoRay is a right answer.
template <class M>
struct RayKernel {
  RayKernel(const double* /*p*/, double /*lens*/) {}
  UnitRay operator()(double /*u*/, double /*v*/) const { return {0.0, 0.0, kAskModel}; }
};

/// p[0..3] = fx fy cx cy, inverted.
struct PixelToPlane {
  double inverse_fx;
  double inverse_fy;
  double cx;
  double cy;
  explicit PixelToPlane(const double* p) : inverse_fx(1.0 / p[0]), inverse_fy(1.0 / p[1]), cx(p[2]), cy(p[3]) {}
  [[nodiscard]] double x(double u) const { return (u - cx) * inverse_fx; }
  [[nodiscard]] double y(double v) const { return (v - cy) * inverse_fy; }
};

/// To be added to a z. Conditions are joined by sums of these rather than by &&, of which not every compiler makes SIMD.
inline double ask_unless(bool sure) { return sure ? 0.0 : kAskModel; }

inline UnitRay normalised(double x, double y, double z, double doubt = 0.0) {
  const double scale = 1.0 / std::sqrt(x * x + y * y + z * z);
  return {scale * x, scale * y, scale * z + doubt};
}

template <>
struct RayKernel<Pinhole> {
  PixelToPlane plane;
  RayKernel(const double* p, double /*lens*/) : plane(p) {}
  UnitRay operator()(double u, double v) const { return normalised(plane.x(u), plane.y(v), 1.0); }
};

/// ucm is eucm with beta = 1.
struct EucmRays {
  PixelToPlane plane;
  double alpha;
  double beta;
  EucmRays(const double* p, double b) : plane(p), alpha(p[4]), beta(b) {}
  UnitRay operator()(double u, double v) const {
    const double x = plane.x(u);
    const double y = plane.y(v);
    const double r2 = beta * (x * x + y * y);
    const double radicand = 1.0 - (2.0 * alpha - 1.0) * r2;
    const double denominator = alpha * std::sqrt(std::abs(radicand)) + (1.0 - alpha);
    return normalised(x, y, (1.0 - alpha * alpha * r2) / denominator,
                      ask_unless(radicand > 0.0) + ask_unless(denominator > 0.0));
  }
};
template <>
struct RayKernel<Ucm> : EucmRays {
  RayKernel(const double* p, double /*lens*/) : EucmRays(p, 1.0) {}
};
template <>
struct RayKernel<Eucm> : EucmRays {
  RayKernel(const double* p, double /*lens*/) : EucmRays(p, p[5]) {}
};

template <>
struct RayKernel<Ds> {
  PixelToPlane plane;
  double alpha;
  double xi;
  RayKernel(const double* p, double /*lens*/) : plane(p), alpha(p[4]), xi(p[5]) {}
  UnitRay operator()(double u, double v) const {
    const double x = plane.x(u);
    const double y = plane.y(v);
    const double r2 = x * x + y * y;
    const double inner = 1.0 - (2.0 * alpha - 1.0) * r2;
    const double denominator = alpha * std::sqrt(std::abs(inner)) + (1.0 - alpha);
    const double z = (1.0 - alpha * alpha * r2) / denominator;
    const double outer = z * z + (1.0 - xi * xi) * r2;
    const double factor = (z * xi + std::sqrt(std::abs(outer))) / (z * z + r2);
    const double doubt =
        ask_unless(inner > 0.0) + ask_unless(denominator > 0.0) + ask_unless(outer > 0.0) + ask_unless(factor > 0.0);
    return normalised(factor * x, factor * y, factor * z - xi, doubt);
  }
};

template <>
struct RayKernel<Fov> {
  PixelToPlane plane;
  double w;
  double slope;
  RayKernel(const double* p, double /*lens*/) : plane(p), w(p[4]), slope(2.0 * std::tan(0.5 * p[4])) {}
  UnitRay operator()(double u, double v) const {
    const double x = plane.x(u);
    const double y = plane.y(v);
    const double radius = std::sqrt(x * x + y * y + kTiny);
    const double bent = radius * w;
    const SineCosine of_bent = sine_cosine(bent);
    const double scale = of_bent.sine / radius;
    return normalised(scale * x, scale * y, slope * of_bent.cosine, ask_unless(bent < kSurelyInside * std::numbers::pi));
  }
};

/// The angle of a radius that is angle (c[0] + c[1] x + ...), x = angle^kPower.
template <std::size_t N, int kPower>
class PolynomialAngle {
 public:
  PolynomialAngle(const std::array<double, N>& c, double lens, double model)
      : c_(c), none_beyond_(kSurelyOutside * radius(std::min(lens, model)) + kRadiusSlack), largest_(kSurelyInside * model) {
    for (std::size_t k = 0; k < N; ++k) slope_[k] = (1.0 + kPower * static_cast<double>(k)) * c[k];
    const double smooth = std::min(lens, kSmooth * model);
    const double end = radius(smooth);
    start_ = Interpolant(kPower == 2 ? end * end : end, [&](double x) {
      const double at = kPower == 2 ? std::sqrt(x) : x;
      const auto f = [this](double angle, double& value, double& slope) {
        value = radius(angle);
        slope = horner(slope_, power(angle));
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
      step = (angle * horner(c_, t) - r) / horner(slope_, t);
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
  std::array<double, N> slope_{};
  Interpolant start_;
  double none_beyond_;
  double largest_;
};

template <>
struct RayKernel<Kb4> {
  PixelToPlane plane;
  PolynomialAngle<5, 2> angle;
  RayKernel(const double* p, double lens) : plane(p), angle({1.0, p[4], p[5], p[6], p[7]}, lens, Kb4::max_angle(p)) {}
  UnitRay operator()(double u, double v) const { return angle.ray(plane.x(u), plane.y(v)); }
};

template <>
struct RayKernel<Woodscape> {
  double inverse_aspect;
  double cx;
  double cy;
  PolynomialAngle<4, 1> angle;
  RayKernel(const double* p, double lens)
      : inverse_aspect(1.0 / p[4]), cx(p[5]), cy(p[6]), angle({p[0], p[1], p[2], p[3]}, lens, Woodscape::max_angle(p)) {}
  UnitRay operator()(double u, double v) const { return angle.ray(u - cx, (v - cy) * inverse_aspect); }
};

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
    const auto radial = [this](double r, double& value, double& slope) {
      Factor::factor_and_slope(q_.data(), r * r, value, slope);
      slope = value + 2.0 * r * r * slope;
      value *= r;
    };
    double none_beyond = 0.0;
    double end = 0.0;
    double slope = 0.0;
    radial(lens, none_beyond, slope);
    none_beyond = kSurelyOutside * (none_beyond + 3.0 * length(q[2], q[3]) * lens * lens) + kRadiusSlack;
    none_beyond_square_ = std::isfinite(none_beyond) ? none_beyond * none_beyond : kAskModel;
    radial(smooth, end, slope);
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
      double slope = 0.0;
      Factor::factor_and_slope(q_.data(), r2, radial, slope);
      const double xy2 = 2.0 * x * y;
      const double ex = x * radial + p1 * xy2 + p2 * (r2 + 2.0 * x * x) - mx;
      const double ey = y * radial + p1 * (r2 + 2.0 * y * y) + p2 * xy2 - my;
      const double xx = radial + 2.0 * (x * x * slope + p1 * y) + 6.0 * p2 * x;
      const double yy = radial + 2.0 * (y * y * slope + p2 * x) + 6.0 * p1 * y;
      const double across = xy2 * slope + 2.0 * (p1 * x + p2 * y);
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
template <>
struct RayKernel<Radtan> : PerspectiveRays<Radtan, PolynomialFactor> {
  using PerspectiveRays::PerspectiveRays;
};
template <>
struct RayKernel<Rational> : PerspectiveRays<Rational, RationalFactor> {
  using PerspectiveRays::PerspectiveRays;
};

template <>
struct RayKernel<Mei> {
  PixelToPlane plane;
  double xi;
  TangentialInverse<PolynomialFactor> inverse;
  RayKernel(const double* p, double lens)
      : plane(p),
        xi(p[4]),
        inverse(std::array{p[5], p[6], p[7], p[8], 0.0}.data(), radius(p[4], std::min(lens, Mei::max_angle(p))),
                radius(p[4], std::min(lens, kSmooth * Mei::max_angle(p)))) {}
  UnitRay operator()(double u, double v) const {
    const auto point = inverse(plane.x(u), plane.y(v));
    const double radicand = 1.0 + (1.0 - xi * xi) * point.r2;
    const double root = std::sqrt(std::abs(radicand));
    const double factor = (xi + root) / (1.0 + point.r2);
    const double doubt = point.doubt + ask_unless(radicand > 0.0);
    const UnitRay ray = normalised(factor * point.x, factor * point.y, (root - xi * point.r2) / (1.0 + point.r2), doubt);
    return {ray.x, ray.y, point.beyond > 0.0 ? kNoRay : ray.z};
  }

 private:
  static double radius(double xi, double angle) {
    const double denominator = std::cos(angle) + xi;
    return denominator > 0.0 ? std::sin(angle) / denominator : kAskModel;
  }
};

template <>
struct RayKernel<Ocamcalib> {
  double cx;
  double cy;
  double c;
  double d;
  double e;
  double inverse_determinant;
  std::array<double, 9> ahead{};
  double largest_rho;
  RayKernel(const double* p, double /*lens*/)
      : cx(p[0]), cy(p[1]), c(p[2]), d(p[3]), e(p[4]), inverse_determinant(1.0 / (c - d * e)) {
    std::array<double, 9> growth{};
    for (std::size_t k = 0; k < ahead.size(); ++k) {
      ahead[k] = -p[5 + k];
      growth[k] = (1.0 - static_cast<double>(k)) * ahead[k];
    }
    // 0 leaves everything to the model.
    largest_rho = c > d * e ? kSurelyInside * positive_until(growth, std::numeric_limits<double>::infinity()) : 0.0;
  }
  UnitRay operator()(double u, double v) const {
    const double down = (v - cy - d * (u - cx)) * inverse_determinant;
    const double right = (c * (u - cx) - e * (v - cy)) * inverse_determinant;
    const double rho = std::sqrt(down * down + right * right);
    return normalised(right, down, horner(ahead, rho), ask_unless(rho < largest_rho));
  }
};

}  // namespace fca::internal
