// SPDX-License-Identifier: BSD-3-Clause
// The map of a pinhole view for pixels whose rays point ahead of the source's camera (z > 0), as nearly all of them do: one
// loop from pixel to pixel, without unit rays where a model does not need them.
#pragma once

#include "../models/kernels/batch.h"
#include "matrix3.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>

namespace fca::internal {

/// A ray of any length, z > 0, to its pixel; not finite: ask the model. For models whose formula needs no angle: for the others
/// two loops with unit rays between them are faster.
template <class M>
struct PinholeKernel;

template <>
struct PinholeKernel<Pinhole> {
  double fx, fy, cx, cy;
  explicit PinholeKernel(const double* p) : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]) {}
  PixelOfRay operator()(double x, double y, double z) const {
    const double scale = 1.0 / z;
    return {fx * (scale * x) + cx, fy * (scale * y) + cy};
  }
};

/// The sum of two parts is at least this share of the larger one; below it their difference has too few digits left.
inline constexpr double kLeastShare = 1e-3;

/// ucm is eucm with beta = 1.
struct EucmPinholeKernel {
  double fx, fy, cx, cy, alpha, beta;
  EucmPinholeKernel(const double* p, double b) : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]), alpha(p[4]), beta(b) {}
  PixelOfRay operator()(double x, double y, double z) const {
    const double d = std::sqrt(beta * (x * x + y * y) + z * z);
    const double scale = 1.0 / (alpha * d + (1.0 - alpha) * z);
    return {fx * (scale * x) + cx, fy * (scale * y) + cy};
  }
};
template <>
struct PinholeKernel<Ucm> : EucmPinholeKernel {
  explicit PinholeKernel(const double* p) : EucmPinholeKernel(p, 1.0) {}
};
template <>
struct PinholeKernel<Eucm> : EucmPinholeKernel {
  explicit PinholeKernel(const double* p) : EucmPinholeKernel(p, p[5]) {}
};

template <>
struct PinholeKernel<Ds> {
  double fx, fy, cx, cy, alpha, xi;
  explicit PinholeKernel(const double* p) : fx(p[0]), fy(p[1]), cx(p[2]), cy(p[3]), alpha(p[4]), xi(p[5]) {}
  PixelOfRay operator()(double x, double y, double z) const {
    const double r2 = x * x + y * y;
    const double k = xi * std::sqrt(r2 + z * z) + z;
    const double d = std::sqrt(r2 + k * k);
    const double sum = alpha * d + (1.0 - alpha) * k;
    const double scale = 1.0 / sum + ask_unless(sum > kLeastShare * d);
    return {fx * (scale * x) + cx, fy * (scale * y) + cy};
  }
};

using AnyPinholeKernel = std::variant<PinholeKernel<Pinhole>, PinholeKernel<Ucm>, PinholeKernel<Eucm>, PinholeKernel<Ds>>;

/// Pixels of a row of a pinhole image to pixels of the source.
class PinholePixels {
 public:
  /// `to_source`: takes (u, v, 1) of the pinhole image to the source's ray. `surely_seen`: rays whose cosine is above it lie in
  /// the source's domain. Nothing for a source without a kernel.
  [[nodiscard]] static std::optional<PinholePixels> of(const CameraModel& source, const Matrix3& to_source, double surely_seen);

  /// Whether the rays of the pixels u = first .. first + count - 1 point ahead.
  [[nodiscard]] bool covers(double first, double v, std::size_t count) const;

  /// Writes u and v of each of them; returns how many of these numbers are not sure: those are not finite.
  [[nodiscard]] std::size_t operator()(double first, double v, std::size_t count, float* uv) const;

 private:
  PinholePixels(const AnyPinholeKernel& kernel, const Matrix3& to_source, double surely_seen);

  AnyPinholeKernel kernel_;
  Matrix3 to_source_;
  double least_square_;  ///< Of a cosine.
};

}  // namespace fca::internal
