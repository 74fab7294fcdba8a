// SPDX-License-Identifier: BSD-3-Clause
// Differences in words.
#pragma once

#include <fca/compare/report.h>

#include <string>

namespace fca::cli {

/// "0.31 deg"; rounding reads as 0.
[[nodiscard]] std::string angle_text(double radians);
/// "3 mm"
[[nodiscard]] std::string length_text(double metres);
/// "IMU.T_b_c1 is the inverse of what it should be: it holds T_cam0_imu0"
[[nodiscard]] std::string sentence(const Mistake& mistake);
/// "IMU.T_b_c1"
[[nodiscard]] std::string subject_of(const Mistake& mistake);

}  // namespace fca::cli
