// SPDX-License-Identifier: BSD-3-Clause
// Differences as messages.
#pragma once

#include <fca/compare/report.h>
#include <fca/message.h>

namespace fca {

/// "T_cam1_cam0 differs by 0.8 deg and 3 mm"
[[nodiscard]] Message facts_of(const PoseComparison& pose);
/// "imu0 gyroscope noise is 10 times the reference's"
[[nodiscard]] Message facts_of(const FactComparison& fact);

/// Rounding is no difference: 1.8e-14 deg reads as 0.
[[nodiscard]] double degrees_apart(double radians);
[[nodiscard]] double millimetres_apart(double metres);

}  // namespace fca
