// SPDX-License-Identifier: BSD-3-Clause
// Converts IMU noise that is not given as densities to densities.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>
#include <fca/toolkit/inputs.h>

#include <string>

namespace fca {

/// Sets the rate [Hz] of the IMUs whose files do not contain it. False, with an error, if a file contains another rate, or
/// there is no IMU.
[[nodiscard]] bool set_imu_rate(double rate_hz, const std::string& input, Rig& rig, Diagnostics& diagnostics);

/// Converts the rig's IMU noise to densities (standard deviations in continuous time) and adds a note. `input`: the file's name
/// for errors. False, with an error, if there is no IMU, or no rate although noise of single samples needs one.
[[nodiscard]] bool make_densities(NoiseKind kind, const std::string& input, Rig& rig, Diagnostics& diagnostics);

}  // namespace fca
