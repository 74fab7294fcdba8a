// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/rays.h"

#include <fca/models/division.h>

namespace fca::internal {

template <>
struct RayKernel<Division> {
  PixelToPlane plane;
  double k;
  RayKernel(const double* p, double /*lens*/) : plane(p), k(p[4]) {}
  UnitRay operator()(double u, double v) const {
    const double x = plane.x(u);
    const double y = plane.y(v);
    const double bend = k * (x * x + y * y);
    return normalised(x, y, 1.0 + bend, ask_unless(bend < kSurelyInside));
  }
};

}  // namespace fca::internal
