// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/pixels.h"
#include "../kernels/rays.h"
#include "../kernels/tangential_inverse.h"

#include <fca/models/rational.h>

#include <algorithm>
#include <array>

namespace fca::internal {

template <>
struct RayKernel<Rational> : PerspectiveRays<Rational, RationalFactor> {
  using PerspectiveRays::PerspectiveRays;
};

template <>
struct PixelKernel<Rational> {
  std::array<double, 12> p;
  PixelKernel(const double* values, double /*max_angle_rad*/) { std::copy_n(values, p.size(), p.data()); }
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

}  // namespace fca::internal
