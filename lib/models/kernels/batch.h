// SPDX-License-Identifier: BSD-3-Clause
// Many pixels at a time through a pair of models, as SIMD where the compiler and the processor have it.
#pragma once

#include "../kernels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

namespace fca::internal {

/// What a pair of models computes for a pixel.
enum class Verdict : std::uint8_t { kOutsideLens, kUnrepresentable, kScored };

struct Point {
  Pixel pixel{};
  double weight = 0.0;  ///< pixels
  double error = 0.0;   ///< px
  double cosine = 0.0;  ///< of the ray's angle from the axis, if scored
  Verdict verdict = Verdict::kOutsideLens;
};

/// Points as one array per figure.
struct Batch {
  static constexpr std::size_t kSize = 256;
  using Lane = std::array<double, kSize>;
  Lane u, v;     ///< The source's pixels.
  Lane x, y, z;  ///< Their rays; z may be kNoRay or kAskModel.
  Lane error;    ///< Distance from (u, v) to the target's pixel of the ray; not finite: ask the model.
  Lane weight;   ///< In pixels.
  Lane spread;   ///< The weight stands for errors that differ so much from the point's.
  std::array<Verdict, kSize> verdict;

  [[nodiscard]] Point point(std::size_t i) const { return {{u[i], v[i]}, weight[i], error[i], z[i], verdict[i]}; }
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

/// Whether the first `count` rays are all there, with a cosine above `cosine` and a finite error.
[[nodiscard]] bool all_within(const Batch& batch, std::size_t count, double cosine);

/// The errors of the first `count` rays of batches; those outside the model's domain, or further from the axis than
/// `max_angle_rad`, get any error.
class BatchErrors {
 public:
  BatchErrors(const CameraModel& model, double max_angle_rad);
  void operator()(Batch& batch, std::size_t count) const;

 private:
  KernelsOf<ModelList>::Pixels kernel_;
};

/// The pixels of the first `count` rays of batches, as u and v; not finite: ask the model. Rays as for BatchErrors.
class BatchPixels {
 public:
  BatchPixels(const CameraModel& model, double max_angle_rad);
  void operator()(Batch& batch, std::size_t count) const;

 private:
  KernelsOf<ModelList>::Pixels kernel_;
};

}  // namespace fca::internal
