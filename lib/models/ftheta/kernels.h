// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/polynomial_angle.h"
#include "../kernels/rays.h"

#include <fca/models/ftheta.h>

namespace fca::internal {

template <>
struct RayKernel<Ftheta> {
  double along_u[2];
  double along_v[2];
  double cx;
  double cy;
  PolynomialAngle<5, 1> angle;
  RayKernel(const double* p, double lens)
      : cx(p[8]), cy(p[9]), angle({p[0], p[1], p[2], p[3], p[4]}, lens, Ftheta::max_angle(p)) {
    const double inverse = 1.0 / (p[5] - p[6] * p[7]);
    along_u[0] = inverse;
    along_u[1] = -p[6] * inverse;
    along_v[0] = -p[7] * inverse;
    along_v[1] = p[5] * inverse;
  }
  UnitRay operator()(double u, double v) const {
    const double du = u - cx;
    const double dv = v - cy;
    return angle.ray(along_u[0] * du + along_u[1] * dv, along_v[0] * du + along_v[1] * dv);
  }
};

}  // namespace fca::internal
