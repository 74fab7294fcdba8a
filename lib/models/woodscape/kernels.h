// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/pixels.h"
#include "../kernels/polynomial_angle.h"
#include "../kernels/rays.h"

#include <fca/models/woodscape.h>

#include <array>
#include <cmath>

namespace fca::internal {

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

template <>
struct PixelKernel<Woodscape> {
  double aspect, cx, cy;
  std::array<double, 4> radial;
  PixelKernel(const double* p, double /*max_angle_rad*/) : aspect(p[4]), cx(p[5]), cy(p[6]), radial{p[0], p[1], p[2], p[3]} {}
  PixelOfRay operator()(const UnitRay& ray) const {
    const double r = std::sqrt(ray.x * ray.x + ray.y * ray.y + kTiny);
    const double angle = angle_of(ray.z, r);
    const double scale = angle * horner(radial, angle) / r;
    return {scale * ray.x + cx, aspect * scale * ray.y + cy};
  }
};

}  // namespace fca::internal
