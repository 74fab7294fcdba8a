// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

namespace fca::test {

/// A map of the plane, its Jacobian at a point in polar coordinates by differences: {d x'/d x, d x'/d y, d y'/d x, d y'/d y}.
template <class Map>
std::array<long double, 4> plane_jacobian(const Map& map, long double r, long double azimuth) {
  constexpr long double h = 1e-7L;
  const long double x = r * std::cos(azimuth);
  const long double y = r * std::sin(azimuth);
  const auto right = map(x + h, y);
  const auto left = map(x - h, y);
  const auto down = map(x, y + h);
  const auto up = map(x, y - h);
  return {(right[0] - left[0]) / (2 * h), (down[0] - up[0]) / (2 * h), (right[1] - left[1]) / (2 * h),
          (down[1] - up[1]) / (2 * h)};
}

}  // namespace fca::test
