// SPDX-License-Identifier: BSD-3-Clause
#include "degrees.h"

#include <fca/convert/angle_limit.h>
#include <fca/convert/field_of_view.h>
#include <fca/rig/rotation.h>
#include <fca/toolkit/image_field.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace fca {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// Rounding error [rad] of an angle at the edge of the scored part.
constexpr double kSameAngle = 1e-9;

/// A field in which no cell is scored, over the image of the camera's field of view.
ImageField empty_field(const ImageSize& image, int most_cells) {
  ImageField field;
  field.image = image;
  const double scale = std::min(1.0, static_cast<double>(most_cells) / std::max(image.width, image.height));
  field.columns = std::max(1, static_cast<int>(std::lround(scale * image.width)));
  field.rows = std::max(1, static_cast<int>(std::lround(scale * image.height)));
  const auto cells = static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows);
  field.values.assign(cells, kNone);
  field.parts.assign(cells, Part::kOutsideLens);
  return field;
}

/// The cells of a field whose rays are inside the lens.
struct LensCells {
  std::vector<std::size_t> cells;  ///< Indices into the field.
  std::vector<double> pixels;      ///< u, v of each.
  std::vector<double> rays;        ///< x, y, z of each, in the camera's frame.

  [[nodiscard]] std::size_t size() const { return cells.size(); }
  [[nodiscard]] Pixel pixel(std::size_t i) const { return {pixels[2 * i], pixels[2 * i + 1]}; }
  [[nodiscard]] Ray ray(std::size_t i) const { return {rays[3 * i], rays[3 * i + 1], rays[3 * i + 2]}; }
  void resize(std::size_t count) {
    cells.resize(count);
    pixels.resize(2 * count);
    rays.resize(3 * count);
  }
  void set(std::size_t i, std::size_t cell, const Pixel& pixel, const Ray& ray) {
    cells[i] = cell;
    std::copy_n(pixel.begin(), 2, &pixels[2 * i]);
    std::copy_n(ray.begin(), 3, &rays[3 * i]);
  }
};

LensCells cells_in_lens(const ImageField& field, const CameraModel& model, const FieldOfView& field_of_view) {
  LensCells inside;
  inside.resize(field.parts.size());
  std::size_t lit = 0;
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const Pixel pixel = field.pixel(column, row);
      if (field_of_view.is_lit(pixel)) inside.set(lit++, field.index(column, row), pixel, {});
    }
  }
  inside.resize(lit);
  unproject_all(model, inside.pixels, inside.rays);
  const AngleLimit limit(field_of_view.max_angle_rad);
  std::size_t count = 0;
  for (std::size_t i = 0; i < lit; ++i) {
    const Ray ray = inside.ray(i);
    if (std::isfinite(ray[2]) && limit.admits(ray)) inside.set(count++, inside.cells[i], inside.pixel(i), ray);
  }
  inside.resize(count);
  return inside;
}

/// The field of view of a camera with its cells; nothing where the camera has no image size or sees nothing of it.
struct CameraField {
  ImageField field;
  LensCells inside;

  void set(std::size_t i, double value) {
    field.parts[inside.cells[i]] = Part::kScored;
    field.values[inside.cells[i]] = value;
  }
};

std::optional<CameraField> field_of(const Camera& camera, std::optional<double> limit_rad, int most_cells) {
  Diagnostics discarded;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, limit_rad, discarded);
  if (!field_of_view) return std::nullopt;
  CameraField result{empty_field(field_of_view->size, most_cells), {}};
  result.inside = cells_in_lens(result.field, camera.model, *field_of_view);
  return result;
}

constexpr int kAround = 90;  // azimuths

/// Unit rays at the angles 0, ..., `end_rad` from the axis in `steps` steps, kAround azimuths of each, as x y z x y z ...
std::vector<double> rays_by_angle(double end_rad, int steps) {
  std::vector<double> rays;
  rays.reserve(3 * static_cast<std::size_t>(kAround * (steps + 1)));
  for (int i = 0; i <= steps; ++i) {
    const double angle = end_rad * i / steps;
    for (int j = 0; j < kAround; ++j) {
      const double around = 2.0 * std::numbers::pi * j / kAround;
      for (const double part : {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle)})
        rays.push_back(part);
    }
  }
  return rays;
}

void rotate(const Transform& rotation, std::vector<double>& rays) {
  for (auto ray = rays.begin(); ray != rays.end(); ray += 3)
    std::ranges::copy(rotated(rotation, {ray[0], ray[1], ray[2]}), ray);
}

/// The pixels of the rays, as u v u v ...; not a number where there is none.
std::vector<double> pixels_of(const CameraModel& model, const std::vector<double>& rays) {
  std::vector<double> pixels(rays.size() / 3 * 2);
  project_all(model, rays, pixels);
  return pixels;
}

double length(double u, double v) { return std::sqrt(u * u + v * v); }

}  // namespace

std::optional<ImageField> error_field(const Camera& source, const CameraModel& target, std::optional<double> limit_rad,
                                      double max_angle_rad, int most_cells, const Transform* rotation) {
  std::optional<CameraField> result = field_of(source, limit_rad, most_cells);
  if (!result) return std::nullopt;
  const LensCells& inside = result->inside;
  std::vector<double> rays = inside.rays;
  if (rotation != nullptr) rotate(*rotation, rays);
  const std::vector<double> pixels = pixels_of(target, rays);
  const AngleLimit max_angle(max_angle_rad + kSameAngle);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const double error = length(pixels[2 * i] - inside.pixels[2 * i], pixels[2 * i + 1] - inside.pixels[2 * i + 1]);
    if (max_angle.admits(inside.ray(i)) && !std::isnan(error)) {
      result->set(i, error);
    } else {
      result->field.parts[inside.cells[i]] = Part::kUnrepresentable;
    }
  }
  return std::move(result->field);
}

std::optional<ImageField> angle_field(const Camera& camera, std::optional<double> limit_rad, int most_cells) {
  std::optional<CameraField> result = field_of(camera, limit_rad, most_cells);
  if (!result) return std::nullopt;
  for (std::size_t i = 0; i < result->inside.size(); ++i)
    result->set(i, angle_from_axis(result->inside.ray(i)) * kDegreesPerRadian);
  return std::move(result->field);
}

std::vector<ProfilePoint> error_profile(const Camera& source, const CameraModel& target, double max_angle_rad,
                                        const Transform* rotation) {
  std::vector<ProfilePoint> profile;
  if (!source.image_size) return profile;
  const double right = source.image_size->width - 1.0;
  const double bottom = source.image_size->height - 1.0;
  constexpr int kAngles = 240;
  std::vector<double> rays = rays_by_angle(max_angle_rad, kAngles);
  const std::vector<double> here = pixels_of(source.model, rays);
  if (rotation != nullptr) rotate(*rotation, rays);
  const std::vector<double> there = pixels_of(target, rays);
  std::size_t at = 0;
  for (int i = 0; i <= kAngles; ++i) {
    double squares = 0.0;
    double worst = 0.0;
    int count = 0;
    for (int j = 0; j < kAround; ++j, at += 2) {
      const bool is_in_image = here[at] >= 0.0 && here[at] <= right && here[at + 1] >= 0.0 && here[at + 1] <= bottom;
      const double error = length(there[at] - here[at], there[at + 1] - here[at + 1]);
      if (!is_in_image || std::isnan(error)) continue;
      squares += error * error;
      worst = std::max(worst, error);
      ++count;
    }
    if (count > 0) profile.push_back({max_angle_rad * i / kAngles * kDegreesPerRadian, std::sqrt(squares / count), worst});
  }
  return profile;
}

std::vector<RadiusPoint> radius_curve(const CameraModel& model, double to_rad) {
  std::vector<RadiusPoint> curve;
  const Pixel centre = principal_point(model);
  const double end = std::min(to_rad, max_angle(model));
  constexpr int kAngles = 180;
  const std::vector<double> pixels = pixels_of(model, rays_by_angle(end, kAngles));
  std::size_t at = 0;
  for (int i = 0; i <= kAngles; ++i) {
    double sum = 0.0;
    for (int j = 0; j < kAround; ++j, at += 2) sum += length(pixels[at] - centre[0], pixels[at + 1] - centre[1]);
    // The curve ends at the first angle at which an azimuth has no pixel: a mean over fewer azimuths would jump.
    if (!std::isfinite(sum)) break;
    curve.push_back({end * i / kAngles * kDegreesPerRadian, sum / kAround});
  }
  return curve;
}

}  // namespace fca
