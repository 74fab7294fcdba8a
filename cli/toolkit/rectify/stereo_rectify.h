// SPDX-License-Identifier: BSD-3-Clause
// cv::stereoRectify and cv::fisheye::stereoRectify, in numbers alone: the command has OpenCV in a module.
#pragma once

#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <vector>

namespace fca {

/// Matrices row by row.
struct OpenCvPair {
  bool is_fisheye = false;
  std::array<std::array<double, 9>, 2> K{};
  std::array<std::vector<double>, 2> D{};
  ImageSize size;
  ImageSize new_size;
  std::array<double, 9> R{};  ///< Of T_second_first.
  std::array<double, 3> T{};
  double alpha = 0.0;  ///< Of a fisheye: balance.
};
struct OpenCvRectification {
  std::array<std::array<double, 9>, 2> R{};
  std::array<std::array<double, 12>, 2> P{};
};

/// With CALIB_ZERO_DISPARITY. Nothing where OpenCV throws.
[[nodiscard]] std::optional<OpenCvRectification> stereo_rectify(const OpenCvPair& pair);

}  // namespace fca
