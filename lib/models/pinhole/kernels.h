// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/rays.h"

#include <fca/models/pinhole.h>

namespace fca::internal {

template <>
struct RayKernel<Pinhole> {
  PixelToPlane plane;
  RayKernel(const double* p, double /*lens*/) : plane(p) {}
  UnitRay operator()(double u, double v) const { return normalised(plane.x(u), plane.y(v), 1.0); }
};

}  // namespace fca::internal
