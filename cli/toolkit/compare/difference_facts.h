// SPDX-License-Identifier: BSD-3-Clause
// Messages that describe differences between two files.
#pragma once

#include <fca/compare/report.h>
#include <fca/message.h>

namespace fca {

/// "T_cam1_cam0 differs by 0.8 deg and 3 mm"
[[nodiscard]] Message facts_of(const PoseComparison& pose);
/// "imu0 gyroscope noise is 10 times the reference's"
[[nodiscard]] Message facts_of(const FactComparison& fact);

/// Converts a difference to the unit of the messages. A difference below 1e-9 (rad or m) is a rounding error and becomes 0.
[[nodiscard]] double degrees_apart(double radians);
[[nodiscard]] double millimetres_apart(double metres);

}  // namespace fca
