// SPDX-License-Identifier: BSD-3-Clause
// Unit ray -> pixel for many rays of one camera, after the pattern of rays.h. Every ray is given to lie inside the
// model's domain, where formula() and project() are one; a pixel that is not finite is a question to the model.
#pragma once

#include "functions.h"
#include "rays.h"

#include <fca/models/camera_model.h>

namespace fca::internal {

struct PixelOfRay {
  double u;
  double v;
};

/// The model's formula. Specialisations, PixelKernel(p, reach) for rays within the angle `reach`, are for formulas of which a
/// compiler makes no SIMD.
template <class M>
struct PixelKernel {
  std::array<double, kParameterCount<M>> p;
  PixelKernel(const double* values, double /*reach*/) { std::copy_n(values, p.size(), p.data()); }
  PixelOfRay operator()(const UnitRay& ray) const {
    const double xyz[3] = {ray.x, ray.y, ray.z};
    double pixel[2] = {0.0, 0.0};
    const bool valid = M::template formula<double>(p.data(), xyz, pixel);
    return {valid ? pixel[0] : kAskModel, pixel[1]};
  }
};

template <>
struct PixelKernel<Ds> {
  double fx, fy, cx, cy, alpha, xi;
  PixelKernel(const double* p, double /*reach*/) : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]), alpha(p[4]), xi(p[5]) {}
  PixelOfRay operator()(const UnitRay& ray) const {
    const double r2 = ray.x * ray.x + ray.y * ray.y;
    const double behind = (xi * xi * r2 + (xi - 1.0) * (xi + 1.0) * ray.z * ray.z) / (xi - ray.z);
    const double k = xi > 0.0 && ray.z < 0.0 ? behind : xi + ray.z;
    const double d = std::sqrt(r2 + k * k);
    const double rest = 1.0 - alpha;
    const double far = (alpha * alpha * r2 + (alpha - rest) * k * k) / (alpha * d - rest * k);
    const double denominator = k >= 0.0 ? alpha * d + rest * k : far;
    const double scale = denominator > 0.0 ? 1.0 / denominator : kAskModel;
    return {fx * (ray.x * scale) + cx, fy * (ray.y * scale) + cy};
  }
};

template <>
struct PixelKernel<Rational> {
  std::array<double, 12> p;
  PixelKernel(const double* values, double /*reach*/) { std::copy_n(values, p.size(), p.data()); }
  PixelOfRay operator()(const UnitRay& ray) const {
    const double inverse = 1.0 / ray.z;
    const double x = ray.x * inverse;
    const double y = ray.y * inverse;
    const double t = x * x + y * y;
    const double denominator = 1.0 + t * (p[9] + t * (p[10] + t * p[11]));
    const double numerator = 1.0 + t * (p[4] + t * (p[5] + t * p[8]));
    const double radial = denominator > 0.0 ? numerator / denominator : kAskModel;
    const double xy2 = 2.0 * x * y;
    const double mx = x * radial + p[6] * xy2 + p[7] * (t + 2.0 * x * x);
    const double my = y * radial + p[6] * (t + 2.0 * y * y) + p[7] * xy2;
    return {p[0] * mx + p[2], p[1] * my + p[3]};
  }
};

template <>
struct PixelKernel<Kb4> {
  double fx, fy, cx, cy;
  std::array<double, 5> radial;
  PixelKernel(const double* p, double /*reach*/)
      : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]), radial{1.0, p[4], p[5], p[6], p[7]} {}
  PixelOfRay operator()(const UnitRay& ray) const {
    const double r = std::sqrt(ray.x * ray.x + ray.y * ray.y + kTiny);
    const double angle = angle_of(ray.z, r);
    const double scale = angle * horner(radial, angle * angle) / r;
    return {fx * (scale * ray.x) + cx, fy * (scale * ray.y) + cy};
  }
};

template <>
struct PixelKernel<Woodscape> {
  double aspect, cx, cy;
  std::array<double, 4> radial;
  PixelKernel(const double* p, double /*reach*/) : aspect(p[4]), cx(p[5]), cy(p[6]), radial{p[0], p[1], p[2], p[3]} {}
  PixelOfRay operator()(const UnitRay& ray) const {
    const double r = std::sqrt(ray.x * ray.x + ray.y * ray.y + kTiny);
    const double angle = angle_of(ray.z, r);
    const double scale = angle * horner(radial, angle) / r;
    return {scale * ray.x + cx, aspect * scale * ray.y + cy};
  }
};

template <>
struct PixelKernel<Fov> {
  double fx, fy, cx, cy, inverse_w, slope;
  PixelKernel(const double* p, double /*reach*/)
      : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]), inverse_w(1.0 / p[4]), slope(2.0 * std::tan(0.5 * p[4])) {}
  PixelOfRay operator()(const UnitRay& ray) const {
    const double r = std::sqrt(ray.x * ray.x + ray.y * ray.y + kTiny);
    const double scale = angle_of(ray.z, slope * r) * inverse_w / r;
    return {fx * (scale * ray.x) + cx, fy * (scale * ray.y) + cy};
  }
};

/// rho is the root of g(rho) sin - rho cos, g the height of the ray ahead of the camera: Newton's method from sqrt(1 - cos)
/// times a polynomial of 1 - cos, which is smooth up to 180 degrees.
template <>
struct PixelKernel<Ocamcalib> {
  double cx, cy, c, d, e;
  std::array<double, 9> g{};
  std::array<double, 8> slope{};
  Interpolant start;  ///< rho / sqrt(1 - cos)
  double largest_rho;

  PixelKernel(const double* p, double reach) : cx(p[0]), cy(p[1]), c(p[2]), d(p[3]), e(p[4]) {
    std::array<double, 9> growth{};
    for (std::size_t k = 0; k < g.size(); ++k) {
      g[k] = -p[5 + k];
      growth[k] = (1.0 - static_cast<double>(k)) * g[k];
      if (k > 0) slope[k - 1] = static_cast<double>(k) * g[k];
    }
    // 0 leaves everything to the model.
    largest_rho = !(c > d * e) ? 0.0 : kSurelyInside * positive_until(growth, std::numeric_limits<double>::infinity());
    const double last = std::min(reach, kSmooth * Ocamcalib::max_angle(p));
    start = Interpolant(1.0 - std::cos(last), [&](double below) {
      const double ray[3] = {std::sqrt(below * (2.0 - below)), 0.0, 1.0 - below};
      double pixel[2];
      return Ocamcalib::project(p, ray, pixel) ? (pixel[0] - cx) / std::sqrt(below) : kAskModel;
    });
  }
  PixelOfRay operator()(const UnitRay& ray) const {
    constexpr int kSteps = 2;
    const double r = std::sqrt(ray.x * ray.x + ray.y * ray.y + kTiny);
    const double below = 1.0 - ray.z;
    double rho = std::sqrt(std::abs(below)) * start(below);
    double step = 0.0;
    repeat<kSteps>([&] {
      step = (horner(g, rho) * r - ray.z * rho) / (horner(slope, rho) * r - ray.z);
      rho -= step;
    });
    const double scale = rho / r + ask_unless(std::abs(step) <= kLastStep * rho) + ask_unless(rho < largest_rho);
    const double down = scale * ray.y;
    const double right = scale * ray.x;
    return {e * down + right + cx, c * down + d * right + cy};
  }
};

}  // namespace fca::internal
