// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/batch.h"

#include <fca/models/camera_model.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace fca {

namespace {

using internal::Batch;

/// (u, v) and (x, y, z).
constexpr std::size_t kOfPixel = 2;
constexpr std::size_t kOfRay = 3;
/// A kernel takes as long to make as the model takes for some hundred pixels.
constexpr std::size_t kWorthAKernel = 1000;

void store(const Ray& ray, std::span<double> rays, std::size_t i) { std::ranges::copy(ray, rays.subspan(kOfRay * i).begin()); }

void ask_model(const CameraModel& model, std::span<const double> pixels, std::size_t i, std::span<double> rays) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  store(unproject(model, {pixels[kOfPixel * i], pixels[kOfPixel * i + 1]}).value_or(Ray{kNone, kNone, kNone}), rays, i);
}

/// Whether the pixel is so near that no power of it overflows in a kernel.
bool is_near(double u, double v) {
  constexpr double kFarthest = 1e9;  // px; to the 16th, kernels' highest power, 1e144
  return std::abs(u) < kFarthest && std::abs(v) < kFarthest;
}

/// The angle [rad] of the farthest corner of the smallest rectangle around the pixels; the model's where one has no ray.
double lens_around(const CameraModel& model, std::span<const double> pixels) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Pixel low = {kInfinity, kInfinity};
  Pixel high = {-kInfinity, -kInfinity};
  for (std::size_t i = 0; i + 1 < pixels.size(); i += kOfPixel) {
    for (std::size_t axis = 0; axis < kOfPixel; ++axis) {
      low[axis] = std::min(low[axis], pixels[i + axis]);
      high[axis] = std::max(high[axis], pixels[i + axis]);
    }
  }
  double lens = 0.0;
  for (const Pixel& corner : {low, high, Pixel{low[0], high[1]}, Pixel{high[0], low[1]}}) {
    const std::optional<Ray> ray = unproject(model, corner);
    if (!ray) return max_angle(model);
    lens = std::max(lens, angle_from_axis(*ray));
  }
  return lens;
}

}  // namespace

void unproject_all(const CameraModel& model, std::span<const double> pixels, std::span<double> rays) {
  const std::size_t count = std::min(pixels.size() / kOfPixel, rays.size() / kOfRay);
  if (count < kWorthAKernel) {
    for (std::size_t i = 0; i < count; ++i) ask_model(model, pixels, i, rays);
    return;
  }
  const internal::BatchRays kernel(model, lens_around(model, pixels.first(kOfPixel * count)));
  Batch batch;
  for (std::size_t first = 0; first < count; first += Batch::kSize) {
    const std::size_t size = std::min(Batch::kSize, count - first);
    for (std::size_t i = 0; i < size; ++i) {
      batch.u[i] = pixels[kOfPixel * (first + i)];
      batch.v[i] = pixels[kOfPixel * (first + i) + 1];
    }
    kernel(batch, size);
    for (std::size_t i = 0; i < size; ++i) {
      if (std::isfinite(batch.z[i]) && is_near(batch.u[i], batch.v[i])) {
        store({batch.x[i], batch.y[i], batch.z[i]}, rays, first + i);
      } else {
        ask_model(model, pixels, first + i, rays);
      }
    }
  }
}

}  // namespace fca
