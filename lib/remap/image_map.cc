// SPDX-License-Identifier: BSD-3-Clause
#include "pinhole_kernel.h"
#include "turn_rays.h"

#include <fca/convert/field_of_view.h>
#include <fca/remap/image_map.h>
#include <fca/remap/view.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fca {

using internal::Batch;

namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// How well a model's last angle is known; what is closer to it is left to project().
constexpr double kLastAngleSlack = 1e-7;
/// Of a cosine, near which angles are compared instead.
constexpr double kClose = 1e-9;

internal::Matrix3 rotation_part(const Transform& T) {
  return {T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2)};
}

/// Takes (u, v, 1) of a pinhole image to a ray that the rotation turned.
internal::Matrix3 from_plane(const internal::Matrix3& rotation, const Intrinsics<Pinhole>& pinhole) {
  const auto& [fx, fy, cx, cy] = pinhole.values;
  internal::Matrix3 result{};
  for (std::size_t row = 0; row < 9; row += 3) {
    result[row] = rotation[row] / fx;
    result[row + 1] = rotation[row + 1] / fy;
    result[row + 2] = rotation[row + 2] - cx * result[row] - cy * result[row + 1];
  }
  return result;
}

}  // namespace

struct ImageMapper::Pair {
  CameraModel source;
  std::optional<CameraModel> target;  ///< Nothing: an equirectangular image.
  ImageSize size;
  std::optional<LensCircle> lens;  ///< Outside it the source's image shows nothing.
  internal::Matrix3 rotation;
  bool is_turned;
  double last_rad;                          ///< Nothing is seen beyond.
  double surely_seen;                       ///< Cosines above: the kernel need not ask.
  double maybe_seen;                        ///< Cosines below: nothing is seen.
  std::optional<internal::BatchRays> rays;  ///< Of the target's model.
  internal::BatchPixels pixels;
  std::optional<internal::PinholePixels> pinhole_pixels;  ///< Of a pinhole target, where that is faster.

  Pair(const Camera& from, const ImageSize& to_size, const Transform& T_source_target, double limit_rad)
      : source(from.model),
        size(to_size),
        lens(from.lens_circle),
        rotation(rotation_part(T_source_target)),
        is_turned(rotation != rotation_part(Transform())),
        last_rad(std::min(limit_rad, max_angle(source))),
        surely_seen(std::cos(std::max(0.0, last_rad - kLastAngleSlack)) + kClose),
        maybe_seen(last_rad + kLastAngleSlack < std::numbers::pi ? std::cos(last_rad + kLastAngleSlack) - kClose : -2.0),
        pixels(source, last_rad - kLastAngleSlack) {}

  Pair(const Camera& from, const Camera& to, const Transform& T_source_target, double target_max_angle_rad, double limit_rad)
      : Pair(from, *to.image_size, T_source_target, limit_rad) {
    target = to.model;
    rays.emplace(*target, target_max_angle_rad);
    if (const auto* pinhole = std::get_if<Intrinsics<Pinhole>>(&*target))
      pinhole_pixels = internal::PinholePixels::of(source, from_plane(rotation, *pinhole), surely_seen);
  }

  /// The pixels u = first .. first + count - 1 of a row, at most a batch of them.
  void write(std::size_t first, int v, std::size_t count, float* uv) const;
  void find_rays(Batch& batch, std::size_t count) const;
  /// The place of a ray that the kernels left open, from the source's model.
  void look_closer(const Ray& ray, float* uv) const;
  void remove_dark(std::span<float> uv) const;
};

void ImageMapper::Pair::write(std::size_t first, int v, std::size_t count, float* uv) const {
  const auto left = static_cast<double>(first);
  if (pinhole_pixels && pinhole_pixels->covers(left, v, count)) {
    if ((*pinhole_pixels)(left, v, count, uv) == 0) return;
    for (std::size_t i = 0; i < count; ++i) {
      if (std::isfinite(uv[2 * i]) && std::isfinite(uv[2 * i + 1])) continue;
      const Ray ray = unproject(*target, {left + static_cast<double>(i), static_cast<double>(v)}).value_or(Ray{});
      look_closer({rotation[0] * ray[0] + rotation[1] * ray[1] + rotation[2] * ray[2],
                   rotation[3] * ray[0] + rotation[4] * ray[1] + rotation[5] * ray[2],
                   rotation[6] * ray[0] + rotation[7] * ray[1] + rotation[8] * ray[2]},
                  uv + 2 * i);
    }
    return;
  }
  Batch batch;
  for (std::size_t i = 0; i < count; ++i) {
    batch.u[i] = left + static_cast<double>(i);
    batch.v[i] = v;
  }
  find_rays(batch, count);
  pixels(batch, count);
  if (internal::write_pixels(batch, count, surely_seen, uv) == 0) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(batch.z[i] > surely_seen) || !std::isfinite(uv[2 * i]) || !std::isfinite(uv[2 * i + 1]))
      look_closer({batch.x[i], batch.y[i], batch.z[i]}, uv + 2 * i);
  }
}

void ImageMapper::Pair::find_rays(Batch& batch, std::size_t count) const {
  if (!rays) {
    for (std::size_t i = 0; i < count; ++i) {
      const Ray ray = equirectangular_ray(size, {batch.u[i], batch.v[i]});
      batch.x[i] = ray[0];
      batch.y[i] = ray[1];
      batch.z[i] = ray[2];
    }
  } else if ((*rays)(batch, count); internal::count_unknown_rays(batch, count) > 0) {
    for (std::size_t i = 0; i < count; ++i) {
      if (std::isfinite(batch.z[i])) continue;
      const std::optional<Ray> ray = unproject(*target, {batch.u[i], batch.v[i]});
      constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
      batch.x[i] = ray ? (*ray)[0] : kNoNumber;
      batch.y[i] = ray ? (*ray)[1] : kNoNumber;
      batch.z[i] = ray ? (*ray)[2] : kNoNumber;
    }
  }
  if (is_turned) internal::turn_rays(rotation, batch, count);
}

void ImageMapper::Pair::look_closer(const Ray& ray, float* uv) const {
  uv[0] = uv[1] = kNothing;
  if (!(ray[2] >= maybe_seen) || angle_from_axis(ray) > last_rad) return;
  const std::optional<Pixel> pixel = project(source, ray);
  if (!pixel) return;
  const auto u = static_cast<float>((*pixel)[0]);
  const auto v = static_cast<float>((*pixel)[1]);
  if (!std::isfinite(u) || !std::isfinite(v)) return;
  uv[0] = u;
  uv[1] = v;
}

/// Places outside the lens.
void ImageMapper::Pair::remove_dark(std::span<float> uv) const {
  for (std::size_t i = 0; i + 1 < uv.size(); i += 2) {
    if (!lens->contains({static_cast<double>(uv[i]), static_cast<double>(uv[i + 1])})) uv[i] = uv[i + 1] = kNothing;
  }
}

ImageMapper::ImageMapper(std::unique_ptr<const Pair> pair) : pair_(std::move(pair)) {}
ImageMapper::ImageMapper(ImageMapper&&) noexcept = default;
ImageMapper& ImageMapper::operator=(ImageMapper&&) noexcept = default;
ImageMapper::~ImageMapper() = default;

std::optional<ImageMapper> ImageMapper::between(const Camera& source, const Camera& target, const Transform& T_source_target,
                                                std::optional<double> limit_rad, Diagnostics& diagnostics) {
  const std::optional<FieldOfView> from = field_of_view_of(source, limit_rad, diagnostics);
  const std::optional<FieldOfView> to = field_of_view_of(target, std::nullopt, diagnostics);
  if (!from || !to) return std::nullopt;
  return ImageMapper(
      std::make_unique<const Pair>(source, target, T_source_target, to->max_angle_rad, limit_rad.value_or(std::numbers::pi)));
}

std::optional<ImageMapper> ImageMapper::to_equirectangular(const Camera& source, const ImageSize& size,
                                                           const Transform& T_source_target, std::optional<double> limit_rad,
                                                           Diagnostics& diagnostics) {
  if (!field_of_view_of(source, limit_rad, diagnostics)) return std::nullopt;
  return ImageMapper(std::make_unique<const Pair>(source, size, T_source_target, limit_rad.value_or(std::numbers::pi)));
}

ImageSize ImageMapper::size() const { return pair_->size; }

void ImageMapper::row(int v, std::span<float> uv) const {
  const auto width = static_cast<std::size_t>(pair_->size.width);
  for (std::size_t first = 0; first < width; first += Batch::kSize)
    pair_->write(first, v, std::min(Batch::kSize, width - first), uv.data() + 2 * first);
  if (pair_->lens) pair_->remove_dark(uv.first(2 * width));
}

ImageMap image_map(const ImageMapper& mapper) {
  const ImageSize size = mapper.size();
  const auto stride = 2 * static_cast<std::size_t>(size.width);
  ImageMap map{size, std::vector<float>(stride * static_cast<std::size_t>(size.height))};
  for (int v = 0; v < size.height; ++v) mapper.row(v, std::span(map.uv).subspan(static_cast<std::size_t>(v) * stride, stride));
  return map;
}

std::vector<std::uint8_t> seen(const ImageMap& map, const ImageSize& source) {
  constexpr float kSlack = 1.0F / 64.0F;
  const float right = static_cast<float>(source.width - 1) + kSlack;
  const float bottom = static_cast<float>(source.height - 1) + kSlack;
  std::vector<std::uint8_t> mask(map.uv.size() / 2);
  // Without a jump: what is seen has a border in every row.
  const float* uv = map.uv.data();
  for (std::uint8_t& each : mask) {
    const int outside =
        (uv[0] >= -kSlack ? 0 : 1) | (uv[0] <= right ? 0 : 1) | (uv[1] >= -kSlack ? 0 : 1) | (uv[1] <= bottom ? 0 : 1);
    each = static_cast<std::uint8_t>(outside - 1);
    uv += 2;
  }
  return mask;
}

}  // namespace fca
