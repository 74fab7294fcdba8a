// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/fields_of_view.h>

#include <algorithm>
#include <cmath>

namespace fca {

namespace {

double angle_between(const Ray& a, const Ray& b) {
  const Ray cross = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return std::atan2(std::hypot(cross[0], cross[1], cross[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

class View {
 public:
  View(const Camera& camera, double limit)
      : camera_(camera),
        limit_(limit),
        last_{camera.image_size->width - 1.0, camera.image_size->height - 1.0},
        nearest_(principal_point(camera.model)) {
    const Pixel centre = nearest_;
    for (const std::size_t i : {0U, 1U}) nearest_.at(i) = std::clamp(centre.at(i), 0.0, last_.at(i));
    by_axis_ = nearest_ == centre;
  }

  [[nodiscard]] std::optional<double> horizontal() const { return across({0.0, nearest_[1]}, {last_[0], nearest_[1]}); }
  [[nodiscard]] std::optional<double> vertical() const { return across({nearest_[0], 0.0}, {nearest_[0], last_[1]}); }
  [[nodiscard]] std::optional<double> diagonal() const { return across({0.0, 0.0}, last_); }

  [[nodiscard]] std::optional<double> largest_from_axis() const {
    std::optional<double> largest;
    Pixel furthest{};
    const auto look = [&](const Pixel& pixel) {
      const std::optional<Ray> ray = camera_.image_size->holds(pixel) ? ray_at(pixel) : std::nullopt;
      if (!ray || (largest && !(angle_from_axis(*ray) > *largest))) return false;
      largest = angle_from_axis(*ray);
      furthest = pixel;
      return true;
    };
    constexpr int kSteps = 64;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) look({last_[0] * i / kSteps, last_[1] * j / kSteps});
    }
    // A lens that ends inside the image ends between these.
    constexpr double kFinest = 1e-3;  // px
    for (double step = std::max(last_[0], last_[1]) / kSteps; step > kFinest;) {
      const Pixel from = furthest;
      bool moved = false;
      for (const Pixel& way : {Pixel{step, 0.0}, Pixel{-step, 0.0}, Pixel{0.0, step}, Pixel{0.0, -step}})
        moved = look({from[0] + way[0], from[1] + way[1]}) || moved;
      if (!moved) step *= 0.5;
    }
    if (!camera_.lens_circle) return largest;
    constexpr int kAzimuths = 720;
    LensCircle inner = *camera_.lens_circle;
    inner.radius_px *= 1.0 - 1e-12;
    for (int i = 0; i < kAzimuths; ++i) look(inner.rim(2.0 * std::numbers::pi * i / kAzimuths));
    return largest;
  }

 private:
  /// Of what counts as lens.
  [[nodiscard]] std::optional<Ray> ray_at(const Pixel& pixel) const {
    if (camera_.lens_circle && !camera_.lens_circle->contains(pixel)) return std::nullopt;
    const std::optional<Ray> ray = unproject(camera_.model, pixel);
    return ray && angle_from_axis(*ray) <= limit_ ? ray : std::nullopt;
  }

  [[nodiscard]] std::optional<double> across(const Pixel& a, const Pixel& b) const {
    const std::optional<Ray> first = ray_at(a);
    const std::optional<Ray> second = ray_at(b);
    if (!first || !second) return std::nullopt;
    return by_axis_ ? angle_from_axis(*first) + angle_from_axis(*second) : angle_between(*first, *second);
  }

  const Camera& camera_;
  double limit_;
  Pixel last_;     ///< The bottom-right pixel.
  Pixel nearest_;  ///< To the principal point, of the image's.
  bool by_axis_ = true;
};

}  // namespace

std::optional<double> horizontal_field_of_view(const Camera& camera) {
  return camera.image_size ? View(camera, std::numbers::pi).horizontal() : std::nullopt;
}

FieldsOfView fields_of_view(const Camera& camera, double limit) {
  if (!camera.image_size) return {};
  const View view(camera, limit);
  return {view.horizontal(), view.vertical(), view.diagonal(), view.largest_from_axis()};
}

}  // namespace fca
