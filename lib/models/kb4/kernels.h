// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/pixels.h"
#include "../kernels/polynomial_angle.h"
#include "../kernels/rays.h"

#include <fca/models/kb4.h>

#include <array>
#include <cmath>

namespace fca::internal {

template <>
struct RayKernel<Kb4> {
  PixelToPlane plane;
  PolynomialAngle<5, 2> angle;
  RayKernel(const double* p, double lens) : plane(p), angle({1.0, p[4], p[5], p[6], p[7]}, lens, Kb4::max_angle(p)) {}
  UnitRay operator()(double u, double v) const { return angle.ray(plane.x(u), plane.y(v)); }
};

template <>
struct PixelKernel<Kb4> {
  double fx, fy, cx, cy;
  std::array<double, 5> radial;
  PixelKernel(const double* p, double /*max_angle_rad*/)
      : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]), radial{1.0, p[4], p[5], p[6], p[7]} {}
  PixelOfRay operator()(const UnitRay& ray) const {
    const double r = std::sqrt(ray.x * ray.x + ray.y * ray.y + kTiny);
    const double angle = angle_of(ray.z, r);
    const double scale = angle * horner(radial, angle * angle) / r;
    return {fx * (scale * ray.x) + cx, fy * (scale * ray.y) + cy};
  }
};

}  // namespace fca::internal
