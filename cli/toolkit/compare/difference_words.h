// SPDX-License-Identifier: BSD-3-Clause
// Differences as sentences.
#pragma once

#include <fca/compare/report.h>
#include <fca/message.h>

#include <string>

namespace fca {

/// "0.31 deg"; rounding reads as 0.
[[nodiscard]] std::string angle_text(double radians);
/// "3 mm"
[[nodiscard]] std::string length_text(double metres);
/// "IMU.T_b_c1 is the inverse of what it should be: it holds T_cam0_imu0"
[[nodiscard]] std::string sentence(const Mistake& mistake);
/// "IMU.T_b_c1"
[[nodiscard]] std::string subject_of(const Mistake& mistake);
/// "T_cam1_cam0 differs by 0.8 deg and 3 mm"
[[nodiscard]] Message in_words(const PoseComparison& pose);
/// "imu0 gyroscope noise is 10 times the reference's"
[[nodiscard]] Message in_words(const FactComparison& fact);

}  // namespace fca
