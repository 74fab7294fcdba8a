// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/pixels.h"
#include "../kernels/rays.h"

#include <fca/models/fov.h>

#include <cmath>
#include <numbers>

namespace fca::internal {

template <>
struct RayKernel<Fov> {
  PixelToPlane plane;
  double w;
  double tangent;
  RayKernel(const double* p, double /*lens*/) : plane(p), w(p[4]), tangent(2.0 * std::tan(0.5 * p[4])) {}
  UnitRay operator()(double u, double v) const {
    const double x = plane.x(u);
    const double y = plane.y(v);
    const double radius = std::sqrt(x * x + y * y + kTiny);
    const double bent = radius * w;
    const SineCosine of_bent = sine_cosine(bent);
    const double scale = of_bent.sine / radius;
    return normalised(scale * x, scale * y, tangent * of_bent.cosine, ask_unless(bent < kSurelyInside * std::numbers::pi));
  }
};

template <>
struct PixelKernel<Fov> {
  double fx, fy, cx, cy, inverse_w, tangent;
  PixelKernel(const double* p, double /*max_angle_rad*/)
      : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]), inverse_w(1.0 / p[4]), tangent(2.0 * std::tan(0.5 * p[4])) {}
  PixelOfRay operator()(const UnitRay& ray) const {
    const double r = std::sqrt(ray.x * ray.x + ray.y * ray.y + kTiny);
    const double scale = angle_of(ray.z, tangent * r) * inverse_w / r;
    return {fx * (scale * ray.x) + cx, fy * (scale * ray.y) + cy};
  }
};

}  // namespace fca::internal
