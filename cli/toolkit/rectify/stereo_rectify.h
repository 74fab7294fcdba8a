// SPDX-License-Identifier: BSD-3-Clause
// cv::stereoRectify and cv::fisheye::stereoRectify with plain numbers as arguments, since the command loads OpenCV as a module.
#pragma once

#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <vector>

namespace fca {

/// The arguments. Matrices are row-major.
struct OpenCvPair {
  bool is_fisheye = false;
  std::array<std::array<double, 9>, 2> K{};
  std::array<std::vector<double>, 2> D{};
  ImageSize size;
  ImageSize new_size;
  std::array<double, 9> R{};  ///< Rotation of T_second_first.
  std::array<double, 3> T{};
  double alpha = 0.0;  ///< For a fisheye pair, cv::fisheye's balance.
};
struct OpenCvRectification {
  std::array<std::array<double, 9>, 2> R{};
  std::array<std::array<double, 12>, 2> P{};
};

/// Rectifies with CALIB_ZERO_DISPARITY. nullopt if OpenCV throws.
[[nodiscard]] std::optional<OpenCvRectification> stereo_rectify(const OpenCvPair& pair);

}  // namespace fca
