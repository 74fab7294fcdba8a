// SPDX-License-Identifier: BSD-3-Clause
// Many pixels at a time through a pair of models, as SIMD where the compiler and the processor have it.
#pragma once

#include "batch_pixels.h"
#include "batch_rays.h"

#include <array>
#include <cstddef>
#include <variant>

namespace fca::internal {

/// One array per coordinate.
struct Batch {
  static constexpr std::size_t kSize = 256;
  using Lane = std::array<double, kSize>;
  Lane u, v;     ///< The source's pixels.
  Lane x, y, z;  ///< Their rays; z may be kNoRay or kAskModel.
  Lane error;    ///< Distance from (u, v) to the target's pixel of the ray; not finite: ask the model.
};

template <class List>
struct KernelsOf;
template <class... Ms>
struct KernelsOf<TypeList<Ms...>> {
  using Rays = std::variant<RayKernel<Ms>...>;
  using Pixels = std::variant<PixelKernel<Ms>...>;
};

/// The rays of the first `count` pixels of batches.
class BatchRays {
 public:
  /// `lens`: no ray further from the axis is wanted, in radians.
  BatchRays(const CameraModel& model, double lens);
  void operator()(Batch& batch, std::size_t count) const;

 private:
  KernelsOf<ModelList>::Rays kernel_;
};

/// The errors of the first `count` rays of batches; those outside the model's domain, or further from the axis than `reach`,
/// get any error.
class BatchErrors {
 public:
  BatchErrors(const CameraModel& model, double reach);
  void operator()(Batch& batch, std::size_t count) const;

 private:
  KernelsOf<ModelList>::Pixels kernel_;
};

}  // namespace fca::internal
