// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace fca::consumers {

/// Row-major 4 x 4, with Eigen's Quaternion::toRotationMatrix, which takes the quaternion's length for 1.
[[nodiscard]] inline std::array<double, 16> pose_as_if_unit(double w, const std::array<double, 3>& xyz,
                                                            const std::array<double, 3>& translation) {
  const auto [x, y, z] = xyz;
  const double tx = 2.0 * x;
  const double ty = 2.0 * y;
  const double tz = 2.0 * z;
  return {1.0 - (ty * y + tz * z),
          tx * y - tz * w,
          tx * z + ty * w,
          translation[0],  //
          tx * y + tz * w,
          1.0 - (tx * x + tz * z),
          ty * z - tx * w,
          translation[1],  //
          tx * z - ty * w,
          ty * z + tx * w,
          1.0 - (tx * x + ty * y),
          translation[2],  //
          0.0,
          0.0,
          0.0,
          1.0};
}

}  // namespace fca::consumers
