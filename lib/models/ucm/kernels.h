// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../eucm/kernels.h"
#include "../kernels/rays.h"

#include <fca/models/ucm.h>

namespace fca::internal {

template <>
struct RayKernel<Ucm> : EucmRays {
  RayKernel(const double* p, double /*lens*/) : EucmRays(p, 1.0) {}
};

}  // namespace fca::internal
