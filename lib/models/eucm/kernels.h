// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/rays.h"

#include <fca/models/eucm.h>

#include <cmath>

namespace fca::internal {

/// beta is a parameter of eucm, and 1 in ucm.
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
struct RayKernel<Eucm> : EucmRays {
  RayKernel(const double* p, double /*lens*/) : EucmRays(p, p[5]) {}
};

}  // namespace fca::internal
