// SPDX-License-Identifier: BSD-3-Clause
#include "edge_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace fca::internal {

void add_edge(const CameraModel& source, const FieldOfView& field_of_view, std::vector<Correspondence>& samples) {
  constexpr int kAzimuths = 24;
  constexpr double kInside = 1.0 - 1e-7;  // keeps points in the field of view in spite of rounding, also where the lens folds
  constexpr double kLargestWeight = 1e-6;
  const ImageSize& size = field_of_view.size;
  const double weight = std::min(kLargestWeight, 0.25 / (static_cast<double>(size.width) * size.height));
  const auto add = [&](const Pixel& pixel) {
    if (!size.holds(pixel)) return;
    if (const std::optional<Ray> ray = field_of_view.ray(source, pixel)) samples.push_back({*ray, pixel, weight});
  };
  for (const double u : {0.0, size.width - 1.0}) {
    for (const double v : {0.0, size.height - 1.0}) add({u, v});
  }
  for (int i = 0; i < kAzimuths; ++i) {
    const double azimuth = 2.0 * std::numbers::pi * i / kAzimuths;
    if (field_of_view.circle) {
      LensCircle inner = *field_of_view.circle;
      inner.radius_px *= kInside;
      add(inner.rim(azimuth));
    }
    const double angle = field_of_view.max_angle_rad * kInside;
    const Ray ray = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
    if (const std::optional<Pixel> pixel = project(source, ray)) add(*pixel);
  }
}

}  // namespace fca::internal
