// SPDX-License-Identifier: BSD-3-Clause
// Calls cv::stereoRectify and cv::fisheye::stereoRectify. The arguments are plain numbers, because the command loads OpenCV as
// a module.
#pragma once

#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <vector>

namespace fca {

/// The arguments of OpenCV's function, in its notation. Matrices are row-major.
struct OpenCvPair {
  bool is_fisheye = false;
  std::array<std::array<double, 9>, 2> K{};  ///< Camera matrices.
  std::array<std::vector<double>, 2> D{};    ///< Distortion coefficients.
  ImageSize size;                            ///< Size of the original images.
  ImageSize new_size;                        ///< Size of the rectified images.
  std::array<double, 9> R{};                 ///< Rotation of T_second_first.
  std::array<double, 3> T{};                 ///< Translation of T_second_first [m].
  double alpha = 0.0;  ///< Free scaling parameter, 0 to 1. For a fisheye pair it is passed as cv::fisheye's balance.
};
/// The results R1, R2, P1 and P2 of OpenCV's function, row-major.
struct OpenCvRectification {
  std::array<std::array<double, 9>, 2> R{};
  std::array<std::array<double, 12>, 2> P{};
};

/// Calls OpenCV's function with the flag CALIB_ZERO_DISPARITY. nullopt if OpenCV throws.
[[nodiscard]] std::optional<OpenCvRectification> stereo_rectify(const OpenCvPair& pair);

}  // namespace fca
