// SPDX-License-Identifier: BSD-3-Clause
// Differences between files as messages.
#pragma once

#include <fca/compare/report.h>
#include <fca/message.h>

namespace fca {

/// "T_cam1_cam0 differs by 0.8 deg and 3 mm"
[[nodiscard]] Message facts_of(const PoseComparison& pose);
/// "imu0 gyroscope noise is 10 times the reference's"
[[nodiscard]] Message facts_of(const FactComparison& fact);

/// Converts to the unit of messages. Differences below 1e-9 (rad or m) are rounding and give 0.
[[nodiscard]] double degrees_apart(double radians);
[[nodiscard]] double millimetres_apart(double metres);

}  // namespace fca
