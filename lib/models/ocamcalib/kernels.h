// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/pixels.h"
#include "../kernels/rays.h"

#include <fca/models/ocamcalib.h>

#include <array>
#include <cmath>
#include <limits>

namespace fca::internal {

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

/// rho is the root of g(rho) sin - rho cos, g the height of the ray ahead of the camera: Newton's method from sqrt(1 - cos)
/// times a polynomial of 1 - cos, which is smooth up to 180 degrees.
template <>
struct PixelKernel<Ocamcalib> {
  double cx, cy, c, d, e;
  std::array<double, 9> g{};
  std::array<double, 8> derivative{};
  Interpolant start;  ///< rho / sqrt(1 - cos)
  double largest_rho;

  PixelKernel(const double* p, double max_angle_rad) : cx(p[0]), cy(p[1]), c(p[2]), d(p[3]), e(p[4]) {
    std::array<double, 9> growth{};
    for (std::size_t k = 0; k < g.size(); ++k) {
      g[k] = -p[5 + k];
      growth[k] = (1.0 - static_cast<double>(k)) * g[k];
      if (k > 0) derivative[k - 1] = static_cast<double>(k) * g[k];
    }
    // 0 leaves everything to the model.
    largest_rho = !(c > d * e) ? 0.0 : kSurelyInside * positive_until(growth, std::numeric_limits<double>::infinity());
    const double last = std::min(max_angle_rad, kSmooth * Ocamcalib::max_angle(p));
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
      step = (horner(g, rho) * r - ray.z * rho) / (horner(derivative, rho) * r - ray.z);
      rho -= step;
    });
    const double scale = rho / r + ask_unless(std::abs(step) <= kLastStep * rho) + ask_unless(rho < largest_rho);
    const double down = scale * ray.y;
    const double right = scale * ray.x;
    return {e * down + right + cx, c * down + d * right + cy};
  }
};

}  // namespace fca::internal
