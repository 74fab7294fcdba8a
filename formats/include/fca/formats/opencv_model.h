// SPDX-License-Identifier: BSD-3-Clause
// Which of OpenCV's functions a program calls for four distortion coefficients: the file need not say it.
#pragma once

#include <cstdint>
#include <string_view>

namespace fca {

enum class OpenCvModel : std::uint8_t {
  kPinhole,  ///< cv::projectPoints: k1 k2 p1 p2.
  kFisheye,  ///< cv::fisheye: k1 k2 k3 k4.
};

[[nodiscard]] constexpr std::string_view name_of(OpenCvModel model) {
  return model == OpenCvModel::kPinhole ? "pinhole" : "fisheye";
}

}  // namespace fca
