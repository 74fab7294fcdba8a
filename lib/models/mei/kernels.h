// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/rays.h"
#include "../kernels/tangential_inverse.h"

#include <fca/models/mei.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::internal {

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

}  // namespace fca::internal
