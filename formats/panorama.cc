// SPDX-License-Identifier: BSD-3-Clause
#include "panorama.h"

#include <cmath>
#include <numbers>

namespace fca {

Camera panorama(Camera camera) {
  constexpr int kColumns = 72;
  constexpr int kRows = 36;
  const auto [width, height] = *camera.image_size;
  const double per_longitude = width / (2.0 * std::numbers::pi);
  const double per_latitude = height / std::numbers::pi;
  camera.model = Intrinsics<Pinhole>{{per_longitude, per_latitude, 0.5 * width, 0.5 * height}};
  camera.rays.clear();
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const Pixel pixel = {width * (column + 0.5) / kColumns, height * (row + 0.5) / kRows};
      const double longitude = (pixel[0] - 0.5 * width) / per_longitude;
      const double latitude = (pixel[1] - 0.5 * height) / per_latitude;
      const Ray ray = {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
      camera.rays.push_back({ray, pixel, 1.0 / (kRows * kColumns)});
    }
  }
  return camera;
}

}  // namespace fca
