// SPDX-License-Identifier: BSD-3-Clause
// IMU noise that is no density, made one.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>
#include <fca/toolkit/inputs.h>

#include <string>

namespace fca {

/// Sets the rate of the IMUs, which their files do not state. False with an error where one states another, or there is no IMU.
[[nodiscard]] bool set_imu_rate(double rate_hz, const std::string& input, Rig& rig, Diagnostics& diagnostics);

/// The rig's IMU noise as densities (standard deviations in continuous time), with a note; `input` is named in errors. False
/// with an error where there is no IMU, or no rate though single samples need one.
[[nodiscard]] bool make_densities(NoiseKind kind, const std::string& input, Rig& rig, Diagnostics& diagnostics);

}  // namespace fca
