// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/pixels.h"
#include "../kernels/rays.h"

#include <fca/models/ds.h>

#include <cmath>

namespace fca::internal {

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
struct PixelKernel<Ds> {
  double fx, fy, cx, cy, alpha, xi;
  PixelKernel(const double* p, double /*max_angle_rad*/) : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]), alpha(p[4]), xi(p[5]) {}
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

}  // namespace fca::internal
