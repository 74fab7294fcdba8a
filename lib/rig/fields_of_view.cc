// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/fields_of_view.h>

#include <algorithm>
#include <cmath>

namespace fca {

namespace {

std::optional<Ray> ray_within(const CameraModel& model, const Pixel& pixel, double limit) {
  const std::optional<Ray> ray = unproject(model, pixel);
  return ray && angle_from_axis(*ray) <= limit ? ray : std::nullopt;
}

double angle_between(const Ray& a, const Ray& b) {
  const Ray cross = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return std::atan2(std::hypot(cross[0], cross[1], cross[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

class View {
 public:
  View(const CameraModel& model, const ImageSize& size, double limit)
      : model_(model), limit_(limit), last_{size.width - 1.0, size.height - 1.0}, nearest_(principal_point(model)) {
    const Pixel centre = nearest_;
    for (const std::size_t i : {0U, 1U}) nearest_.at(i) = std::clamp(centre.at(i), 0.0, last_.at(i));
    by_axis_ = nearest_ == centre;
  }

  [[nodiscard]] std::optional<double> horizontal() const { return across({0.0, nearest_[1]}, {last_[0], nearest_[1]}); }
  [[nodiscard]] std::optional<double> vertical() const { return across({nearest_[0], 0.0}, {nearest_[0], last_[1]}); }
  [[nodiscard]] std::optional<double> diagonal() const { return across({0.0, 0.0}, last_); }

  [[nodiscard]] std::optional<double> largest_from_axis() const {
    std::optional<double> largest;
    constexpr int kSteps = 64;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const std::optional<Ray> ray = ray_within(model_, {last_[0] * i / kSteps, last_[1] * j / kSteps}, limit_);
        if (ray) largest = std::max(largest.value_or(0.0), angle_from_axis(*ray));
      }
    }
    return largest;
  }

 private:
  [[nodiscard]] std::optional<double> across(const Pixel& a, const Pixel& b) const {
    const std::optional<Ray> first = ray_within(model_, a, limit_);
    const std::optional<Ray> second = ray_within(model_, b, limit_);
    if (!first || !second) return std::nullopt;
    return by_axis_ ? angle_from_axis(*first) + angle_from_axis(*second) : angle_between(*first, *second);
  }

  const CameraModel& model_;
  double limit_;
  Pixel last_;     ///< The bottom-right pixel.
  Pixel nearest_;  ///< To the principal point, of the image's.
  bool by_axis_ = true;
};

}  // namespace

std::optional<double> horizontal_field_of_view(const Camera& camera) {
  return camera.image_size ? View(camera.model, *camera.image_size, std::numbers::pi).horizontal() : std::nullopt;
}

FieldsOfView fields_of_view(const Camera& camera, double limit) {
  if (!camera.image_size) return {};
  const View view(camera.model, *camera.image_size, limit);
  return {view.horizontal(), view.vertical(), view.diagonal(), view.largest_from_axis()};
}

}  // namespace fca
