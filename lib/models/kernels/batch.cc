// SPDX-License-Identifier: BSD-3-Clause
#include "batch.h"

#include "multiversioned.h"
#include "with_kernel.h"

namespace fca::internal {

namespace {

/// Kernels are copied: the compiler then knows that writing to the batch does not change them.
template <class Kernel>
void rays_of(const Kernel kernel, Batch& batch, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const UnitRay ray = kernel(batch.u[i], batch.v[i]);
    batch.x[i] = ray.x;
    batch.y[i] = ray.y;
    batch.z[i] = ray.z;
  }
}

template <class Kernel>
void errors_of(const Kernel kernel, Batch& batch, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const PixelOfRay pixel = kernel({batch.x[i], batch.y[i], batch.z[i]});
    const double du = pixel.u - batch.u[i];
    const double dv = pixel.v - batch.v[i];
    batch.error[i] = std::sqrt(du * du + dv * dv);
  }
}

template <class Kernel>
void pixels_of(const Kernel kernel, Batch& batch, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const PixelOfRay pixel = kernel({batch.x[i], batch.y[i], batch.z[i]});
    batch.u[i] = pixel.u;
    batch.v[i] = pixel.v;
  }
}

FCA_MULTIVERSIONED void all_rays(const KernelsOf<ModelList>::Rays& kernel, Batch& batch, std::size_t count) {
  with_kernel(kernel, [&](const auto& k) { rays_of(k, batch, count); });
}

FCA_MULTIVERSIONED void all_errors(const KernelsOf<ModelList>::Pixels& kernel, Batch& batch, std::size_t count) {
  with_kernel(kernel, [&](const auto& k) { errors_of(k, batch, count); });
}

FCA_MULTIVERSIONED void all_pixels(const KernelsOf<ModelList>::Pixels& kernel, Batch& batch, std::size_t count) {
  with_kernel(kernel, [&](const auto& k) { pixels_of(k, batch, count); });
}

/// How often one of the three conditions fails.
FCA_MULTIVERSIONED long long count_doubts(const Batch& batch, std::size_t count, double cosine) {
  constexpr double kAnyCosine = 2.0;
  constexpr double kLargest = std::numeric_limits<double>::max();
  long long doubts = 0;
  for (std::size_t i = 0; i < count; ++i) {
    doubts += batch.z[i] > cosine ? 0 : 1;
    doubts += batch.z[i] < kAnyCosine ? 0 : 1;
    doubts += batch.error[i] <= kLargest ? 0 : 1;
  }
  return doubts;
}

KernelsOf<ModelList>::Pixels pixel_kernel(const CameraModel& model, double max_angle_rad) {
  return std::visit(
      [&]<class M>(const Intrinsics<M>& m) -> KernelsOf<ModelList>::Pixels {
        return PixelKernel<M>(m.values.data(), max_angle_rad);
      },
      model);
}

}  // namespace

bool all_within(const Batch& batch, std::size_t count, double cosine) { return count_doubts(batch, count, cosine) == 0; }

BatchRays::BatchRays(const CameraModel& model, double lens)
    : kernel_(std::visit(
          [&]<class M>(const Intrinsics<M>& m) -> KernelsOf<ModelList>::Rays { return RayKernel<M>(m.values.data(), lens); },
          model)) {}

void BatchRays::operator()(Batch& batch, std::size_t count) const { all_rays(kernel_, batch, count); }

BatchErrors::BatchErrors(const CameraModel& model, double max_angle_rad) : kernel_(pixel_kernel(model, max_angle_rad)) {}

void BatchErrors::operator()(Batch& batch, std::size_t count) const { all_errors(kernel_, batch, count); }

BatchPixels::BatchPixels(const CameraModel& model, double max_angle_rad) : kernel_(pixel_kernel(model, max_angle_rad)) {}

void BatchPixels::operator()(Batch& batch, std::size_t count) const { all_pixels(kernel_, batch, count); }

}  // namespace fca::internal
