// SPDX-License-Identifier: BSD-3-Clause
// Pixel -> unit ray for many pixels of one camera: what a model's unproject() does again for each pixel is done once (limits,
// and a polynomial from which Newton's method needs few steps), and what remains has neither branches nor calls, so that a
// compiler makes SIMD of a loop over it.
//
// A kernel is right where it answers, and answers nearly everywhere. Where it is not sure, near a model's limit or because
// Newton's method has not ended, it says so, and the caller asks the model. So models need no kernel.
#pragma once

#include "functions.h"

#include <fca/models/camera_model.h>

#include <algorithm>
#include <limits>

namespace fca::internal {

/// Instead of a z: there is surely no ray within the lens. Any other z that is not finite means: ask the model.
inline constexpr double kNoRay = -std::numeric_limits<double>::infinity();
inline constexpr double kAskModel = std::numeric_limits<double>::infinity();

/// The last step of Newton's method, relatively: the next would be about its square.
inline constexpr double kLastStep = 1e-8;
/// Kernels leave to the model what is closer than this to its limit; and further: there no polynomial is near its inverse.
inline constexpr double kSurelyInside = 0.999;
inline constexpr double kSurelyOutside = 1.0 + 1e-9;
/// A field of view may be the axis alone, an image of one pixel: no radius below this is surely outside.
inline constexpr double kRadiusSlack = 1e-6;
inline constexpr double kSmooth = 0.97;
/// Added to squares, so that a radius is never 0 and (x, y) / radius is 0 on the axis.
inline constexpr double kTiny = 1e-300;

struct UnitRay {
  double x;
  double y;
  double z;
};

/// Leaves every pixel to the model. Specialisations: RayKernel(p, lens), lens = the angle where the lens ends, beyond which
/// kNoRay is a right answer.
template <class M>
struct RayKernel {
  RayKernel(const double* /*p*/, double /*lens*/) {}
  UnitRay operator()(double /*u*/, double /*v*/) const { return {0.0, 0.0, kAskModel}; }
};

/// p[0..3] = fx fy cx cy, inverted.
struct PixelToPlane {
  double inverse_fx;
  double inverse_fy;
  double cx;
  double cy;
  explicit PixelToPlane(const double* p) : inverse_fx(1.0 / p[0]), inverse_fy(1.0 / p[1]), cx(p[2]), cy(p[3]) {}
  [[nodiscard]] double x(double u) const { return (u - cx) * inverse_fx; }
  [[nodiscard]] double y(double v) const { return (v - cy) * inverse_fy; }
};

/// To be added to a z. Conditions are joined by sums of these rather than by &&, of which not every compiler makes SIMD.
inline double ask_unless(bool sure) { return sure ? 0.0 : kAskModel; }

inline UnitRay normalised(double x, double y, double z, double doubt = 0.0) {
  const double scale = 1.0 / std::sqrt(x * x + y * y + z * z);
  return {scale * x, scale * y, scale * z + doubt};
}

}  // namespace fca::internal
