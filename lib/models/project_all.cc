// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/batch.h"

#include <fca/models/camera_model.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace fca {

namespace {

using internal::Batch;

/// (x, y, z) and (u, v).
constexpr std::size_t kOfRay = 3;
constexpr std::size_t kOfPixel = 2;
/// A kernel takes as long to make as the model takes for some hundred rays.
constexpr std::size_t kWorthAKernel = 1000;
/// Rounding errors of max_angle() [rad] and of a cosine. So close to the end of the model's domain, the model decides.
constexpr double kAngleSlack = 1e-7;
constexpr double kCosineSlack = 1e-9;

Ray ray_at(std::span<const double> rays, std::size_t i) {
  return {rays[kOfRay * i], rays[kOfRay * i + 1], rays[kOfRay * i + 2]};
}

void store(const Pixel& pixel, std::span<double> pixels, std::size_t i) {
  std::ranges::copy(pixel, pixels.subspan(kOfPixel * i).begin());
}

void ask_model(const CameraModel& model, std::span<const double> rays, std::size_t i, std::span<double> pixels) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  store(project(model, ray_at(rays, i)).value_or(Pixel{kNone, kNone}), pixels, i);
}

/// Writes the ray as a unit ray. One whose length is not a normal number gets z = NaN.
void set_unit_ray(const Ray& ray, Batch& batch, std::size_t i) {
  const double squared = ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2];
  const bool is_usual = squared > std::numeric_limits<double>::min() && squared < std::numeric_limits<double>::max();
  const double length = is_usual ? std::sqrt(squared) : std::numeric_limits<double>::quiet_NaN();
  batch.x[i] = ray[0] / length;
  batch.y[i] = ray[1] / length;
  batch.z[i] = ray[2] / length;
}

/// The largest angle [rad] of the rays from the axis.
double largest_angle(std::span<const double> rays) {
  double lowest = 1.0;  // cosine
  for (std::size_t i = 0; i + kOfRay <= rays.size(); i += kOfRay) {
    const double length = std::sqrt(rays[i] * rays[i] + rays[i + 1] * rays[i + 1] + rays[i + 2] * rays[i + 2]);
    const double cosine = rays[i + 2] / length;
    if (cosine < lowest) lowest = cosine;
  }
  return std::acos(std::max(lowest, -1.0));
}

}  // namespace

void project_all(const CameraModel& model, std::span<const double> rays, std::span<double> pixels) {
  const std::size_t count = std::min(rays.size() / kOfRay, pixels.size() / kOfPixel);
  if (count < kWorthAKernel) {
    for (std::size_t i = 0; i < count; ++i) ask_model(model, rays, i, pixels);
    return;
  }
  const double last = std::max(0.0, max_angle(model) - kAngleSlack);
  const double surely_inside = std::cos(last) + kCosineSlack;
  const internal::BatchPixels kernel(model, std::min(last, largest_angle(rays.first(kOfRay * count)) + kAngleSlack));
  Batch batch;
  for (std::size_t first = 0; first < count; first += Batch::kSize) {
    const std::size_t size = std::min(Batch::kSize, count - first);
    for (std::size_t i = 0; i < size; ++i) set_unit_ray(ray_at(rays, first + i), batch, i);
    kernel(batch, size);
    for (std::size_t i = 0; i < size; ++i) {
      const bool is_sure = batch.z[i] > surely_inside && std::isfinite(batch.u[i]) && std::isfinite(batch.v[i]);
      if (is_sure) {
        store({batch.u[i], batch.v[i]}, pixels, first + i);
      } else {
        ask_model(model, rays, first + i, pixels);
      }
    }
  }
}

}  // namespace fca
