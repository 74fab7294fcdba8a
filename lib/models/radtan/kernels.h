// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../kernels/rays.h"
#include "../kernels/tangential_inverse.h"

#include <fca/models/radtan.h>

namespace fca::internal {

template <>
struct RayKernel<Radtan> : PerspectiveRays<Radtan, PolynomialFactor> {
  using PerspectiveRays::PerspectiveRays;
};

}  // namespace fca::internal
