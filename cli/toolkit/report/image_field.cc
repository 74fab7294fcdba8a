// SPDX-License-Identifier: BSD-3-Clause
#include "degrees.h"

#include <fca/convert/angle_limit.h>
#include <fca/convert/field_of_view.h>
#include <fca/rig/rotation.h>
#include <fca/toolkit/image_field.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace fca {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// Rounding error [rad] of an angle at the edge of the scored part.
constexpr double kSameAngle = 1e-9;

/// The value at a pixel with that ray; nullopt if the target cannot represent it.
using ValueOf = std::function<std::optional<double>(const Pixel&, const Ray&)>;

std::optional<ImageField> field_of(const Camera& camera, std::optional<double> limit_rad, int most_cells,
                                   const ValueOf& value_of) {
  Diagnostics discarded;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, limit_rad, discarded);
  if (!field_of_view) return std::nullopt;
  ImageField field;
  field.image = field_of_view->size;
  const double scale = std::min(1.0, static_cast<double>(most_cells) / std::max(field.image.width, field.image.height));
  field.columns = std::max(1, static_cast<int>(std::lround(scale * field.image.width)));
  field.rows = std::max(1, static_cast<int>(std::lround(scale * field.image.height)));
  const auto cells = static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows);
  field.values.assign(cells, kNone);
  field.parts.assign(cells, Part::kOutsideLens);
  const Lens lens(camera.model);
  const AngleLimit limit(field_of_view->max_angle_rad);
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const Pixel pixel = field.pixel(column, row);
      const std::optional<Ray> ray = field_of_view->is_lit(pixel) ? lens.ray(pixel) : std::nullopt;
      if (!ray || !limit.admits(*ray)) continue;
      const std::optional<double> value = value_of(pixel, *ray);
      field.parts[field.index(column, row)] = value ? Part::kScored : Part::kUnrepresentable;
      if (value) field.values[field.index(column, row)] = *value;
    }
  }
  return field;
}

/// The unit ray at that angle from the axis and azimuth [rad].
Ray direction(double angle, double around) {
  return {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle)};
}

constexpr int kAround = 90;
double around(int i) { return 2.0 * std::numbers::pi * i / kAround; }

}  // namespace

std::optional<ImageField> error_field(const Camera& source, const CameraModel& target, std::optional<double> limit_rad,
                                      double max_angle_rad, int most_cells, const Transform* rotation) {
  const AngleLimit max_angle(max_angle_rad + kSameAngle);
  return field_of(source, limit_rad, most_cells, [&](const Pixel& pixel, const Ray& ray) -> std::optional<double> {
    if (!max_angle.admits(ray)) return std::nullopt;
    const std::optional<Pixel> there = project(target, rotation != nullptr ? rotated(*rotation, ray) : ray);
    if (!there) return std::nullopt;
    return std::hypot((*there)[0] - pixel[0], (*there)[1] - pixel[1]);
  });
}

std::optional<ImageField> angle_field(const Camera& camera, std::optional<double> limit_rad, int most_cells) {
  return field_of(camera, limit_rad, most_cells,
                  [](const Pixel&, const Ray& ray) { return std::optional(angle_from_axis(ray) * kDegreesPerRadian); });
}

std::vector<ProfilePoint> error_profile(const Camera& source, const CameraModel& target, double max_angle_rad,
                                        const Transform* rotation) {
  std::vector<ProfilePoint> profile;
  if (!source.image_size) return profile;
  const double right = source.image_size->width - 1.0;
  const double bottom = source.image_size->height - 1.0;
  constexpr int kAngles = 240;
  for (int i = 0; i <= kAngles; ++i) {
    const double angle = max_angle_rad * i / kAngles;
    double squares = 0.0;
    double worst = 0.0;
    int count = 0;
    for (int j = 0; j < kAround; ++j) {
      const Ray ray = direction(angle, around(j));
      const std::optional<Pixel> here = project(source.model, ray);
      if (!here || (*here)[0] < 0.0 || (*here)[0] > right || (*here)[1] < 0.0 || (*here)[1] > bottom) continue;
      const std::optional<Pixel> there = project(target, rotation != nullptr ? rotated(*rotation, ray) : ray);
      if (!there) continue;
      const double error = std::hypot((*there)[0] - (*here)[0], (*there)[1] - (*here)[1]);
      squares += error * error;
      worst = std::max(worst, error);
      ++count;
    }
    if (count > 0) profile.push_back({angle * kDegreesPerRadian, std::sqrt(squares / count), worst});
  }
  return profile;
}

std::vector<RadiusPoint> radius_curve(const CameraModel& model, double to_rad) {
  std::vector<RadiusPoint> curve;
  const Pixel centre = principal_point(model);
  const double end = std::min(to_rad, max_angle(model));
  constexpr int kAngles = 180;
  for (int i = 0; i <= kAngles; ++i) {
    const double angle = end * i / kAngles;
    double sum = 0.0;
    int count = 0;
    for (int j = 0; j < kAround; ++j) {
      const std::optional<Pixel> pixel = project(model, direction(angle, around(j)));
      if (!pixel) continue;
      sum += std::hypot((*pixel)[0] - centre[0], (*pixel)[1] - centre[1]);
      ++count;
    }
    // The curve ends at the first angle at which an azimuth has no pixel: a mean over fewer azimuths would jump.
    if (count < kAround || !std::isfinite(sum)) break;
    curve.push_back({angle * kDegreesPerRadian, sum / count});
  }
  return curve;
}

}  // namespace fca
