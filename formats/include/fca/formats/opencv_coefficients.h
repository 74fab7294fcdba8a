// SPDX-License-Identifier: BSD-3-Clause
// The coefficients of OpenCV's two functions, in the order of its vectors.
#pragma once

#include <fca/models/camera_model.h>

#include <array>
#include <cstddef>

namespace fca {

/// cv::projectPoints'. Its vectors end after kRadtanCount, kRationalCount, kPrismCount or all of them.
inline constexpr std::array<ParameterId, 14> kOpenCvCoefficients = {"k1", "k2", "p1", "p2", "k3", "k4",    "k5",
                                                                    "k6", "s1", "s2", "s3", "s4", "tau_x", "tau_y"};
inline constexpr std::size_t kRadtanCount = 5;
inline constexpr std::size_t kRationalCount = 8;
inline constexpr std::size_t kPrismCount = 12;

/// So many it takes; with 4 k3 is 0.
inline constexpr std::array<std::size_t, 5> kOpenCvCounts = {4, kRadtanCount, kRationalCount, kPrismCount,
                                                             kOpenCvCoefficients.size()};

/// The smallest of its models that has so many: pinhole, radtan, rational or opencv14.
[[nodiscard]] constexpr std::string_view opencv_model_of(std::size_t count) {
  if (count == 0) return "pinhole";
  if (count <= kRadtanCount) return "radtan";
  return count <= kRationalCount ? "rational" : "opencv14";
}

/// cv::fisheye's.
inline constexpr std::array<ParameterId, 4> kFisheyeCoefficients = {"k1", "k2", "k3", "k4"};

/// How many of kOpenCvCoefficients the model has; 0: it is no model of cv::projectPoints with coefficients.
[[nodiscard]] constexpr std::size_t opencv_count(std::string_view model) {
  if (model == "radtan") return kRadtanCount;
  if (model == "rational") return kRationalCount;
  return model == "opencv14" ? kOpenCvCoefficients.size() : 0;
}

}  // namespace fca
