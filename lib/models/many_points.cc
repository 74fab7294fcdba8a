// SPDX-License-Identifier: BSD-3-Clause
// project_all() and unproject_all(): the kernels of kernels/batch.h, and the model itself where they leave a point open.
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

/// Points as N numbers one behind the other.
template <std::size_t N>
std::array<double, N> point_at(std::span<const double> points, std::size_t i) {
  std::array<double, N> point;
  std::copy_n(points.subspan(N * i).begin(), N, point.begin());
  return point;
}

/// Stores the point; no numbers if there is none.
template <std::size_t N>
void store(const std::optional<std::array<double, N>>& point, std::span<double> points, std::size_t i) {
  std::array<double, N> nothing;
  nothing.fill(std::numeric_limits<double>::quiet_NaN());
  std::ranges::copy(point.value_or(nothing), points.subspan(N * i).begin());
}

Pixel pixel_at(std::span<const double> pixels, std::size_t i) { return point_at<std::tuple_size_v<Pixel>>(pixels, i); }
Ray ray_at(std::span<const double> rays, std::size_t i) { return point_at<std::tuple_size_v<Ray>>(rays, i); }

std::size_t pixels_in(std::span<const double> pixels) { return pixels.size() / std::tuple_size_v<Pixel>; }
std::size_t rays_in(std::span<const double> rays) { return rays.size() / std::tuple_size_v<Ray>; }

/// Calls transform(batch, first, size) for all points in batches, or ask_model(i) for each of a few: a kernel takes as long to
/// make as the model takes for some hundred points.
template <class MakeTransform, class AskModel>
void for_all(std::size_t count, MakeTransform&& make_transform, AskModel&& ask_model) {
  constexpr std::size_t kWorthAKernel = 1000;
  if (count < kWorthAKernel) {
    for (std::size_t i = 0; i < count; ++i) ask_model(i);
    return;
  }
  const auto transform = make_transform();
  Batch batch;
  for (std::size_t first = 0; first < count; first += Batch::kSize)
    transform(batch, first, std::min(Batch::kSize, count - first));
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
  for (std::size_t i = 0; i < pixels_in(pixels); ++i) {
    const Pixel pixel = pixel_at(pixels, i);
    for (std::size_t axis = 0; axis < pixel.size(); ++axis) {
      low[axis] = std::min(low[axis], pixel[axis]);
      high[axis] = std::max(high[axis], pixel[axis]);
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

void project_all(const CameraModel& model, std::span<const double> rays, std::span<double> pixels) {
  // Rounding errors of max_angle() [rad] and of a cosine. So close to the end of the model's domain, the model decides.
  constexpr double kAngleSlack = 1e-7;
  constexpr double kCosineSlack = 1e-9;
  const auto ask_model = [&](std::size_t i) { store(project(model, ray_at(rays, i)), pixels, i); };
  const auto make_transform = [&] {
    const double last = std::max(0.0, max_angle(model) - kAngleSlack);
    return [&, kernel = internal::BatchPixels(model, last), surely_inside = std::cos(last) + kCosineSlack](
               Batch& batch, std::size_t first, std::size_t size) {
      for (std::size_t i = 0; i < size; ++i) set_unit_ray(ray_at(rays, first + i), batch, i);
      kernel(batch, size);
      for (std::size_t i = 0; i < size; ++i) {
        const bool is_sure = batch.z[i] > surely_inside && std::isfinite(batch.u[i]) && std::isfinite(batch.v[i]);
        is_sure ? store(std::optional(Pixel{batch.u[i], batch.v[i]}), pixels, first + i) : ask_model(first + i);
      }
    };
  };
  for_all(std::min(rays_in(rays), pixels_in(pixels)), make_transform, ask_model);
}

void unproject_all(const CameraModel& model, std::span<const double> pixels, std::span<double> rays) {
  const auto ask_model = [&](std::size_t i) { store(unproject(model, pixel_at(pixels, i)), rays, i); };
  const auto make_transform = [&] {
    return [&, kernel = internal::BatchRays(model, lens_around(model, pixels))](Batch& batch, std::size_t first,
                                                                                std::size_t size) {
      for (std::size_t i = 0; i < size; ++i) {
        const Pixel pixel = pixel_at(pixels, first + i);
        batch.u[i] = pixel[0];
        batch.v[i] = pixel[1];
      }
      kernel(batch, size);
      for (std::size_t i = 0; i < size; ++i) {
        const bool is_sure = std::isfinite(batch.z[i]) && is_near(batch.u[i], batch.v[i]);
        is_sure ? store(std::optional(Ray{batch.x[i], batch.y[i], batch.z[i]}), rays, first + i) : ask_model(first + i);
      }
    };
  };
  for_all(std::min(pixels_in(pixels), rays_in(rays)), make_transform, ask_model);
}

}  // namespace fca
