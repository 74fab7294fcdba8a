// SPDX-License-Identifier: BSD-3-Clause
// Unit ray -> pixel for many rays of one camera, after the pattern of rays.h. Every ray is given to lie inside the
// model's domain, where formula() and project() are one; a pixel that is not finite is a question to the model.
#pragma once

#include "functions.h"
#include "rays.h"

#include <fca/models/camera_model.h>

namespace fca::internal {

struct PixelOfRay {
  double u;
  double v;
};

/// The model's formula. Specialisations, PixelKernel(p, reach) for rays within the angle `max_angle_rad`, are for formulas of
/// which a compiler makes no SIMD.
template <class M>
struct PixelKernel {
  std::array<double, kParameterCount<M>> p;
  PixelKernel(const double* values, double /*max_angle_rad*/) { std::copy_n(values, p.size(), p.data()); }
  PixelOfRay operator()(const UnitRay& ray) const {
    const double xyz[3] = {ray.x, ray.y, ray.z};
    double pixel[2] = {0.0, 0.0};
    const bool valid = M::template formula<double>(p.data(), xyz, pixel);
    return {valid ? pixel[0] : kAskModel, pixel[1]};
  }
};

}  // namespace fca::internal
