// SPDX-License-Identifier: BSD-3-Clause
#include <fca/remap/view.h>

#include <array>
#include <cmath>
#include <numbers>

namespace fca {

namespace {

/// About coordinate axis 0, 1 or 2.
Transform about(int axis, double angle) {
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  Transform turn;
  turn(next, next) = turn(last, last) = std::cos(angle);
  turn(last, next) = std::sin(angle);
  turn(next, last) = -std::sin(angle);
  return turn;
}

}  // namespace

CameraModel pinhole_of_view(const ImageSize& size, double full_fov_rad) {
  const double f = 0.5 * size.width / std::tan(0.5 * full_fov_rad);
  return Intrinsics<Pinhole>{{f, f, 0.5 * (size.width - 1), 0.5 * (size.height - 1)}};
}

Ray equirectangular_ray(const ImageSize& size, const Pixel& pixel) {
  const double longitude = ((pixel[0] + 0.5) / size.width - 0.5) * 2.0 * std::numbers::pi;
  const double down = ((pixel[1] + 0.5) / size.height - 0.5) * std::numbers::pi;
  return {std::cos(down) * std::sin(longitude), std::sin(down), std::cos(down) * std::cos(longitude)};
}

Transform turned(double yaw, double pitch, double roll) { return about(1, yaw) * about(0, pitch) * about(2, roll); }

}  // namespace fca
