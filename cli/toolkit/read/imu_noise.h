// SPDX-License-Identifier: BSD-3-Clause
// Converts noise values of an IMU to noise densities.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>
#include <fca/toolkit/inputs.h>

#include <string>

namespace fca {

/// Sets the rate [Hz] of all IMUs. False, with an error, if an IMU already has another rate, or if there is no IMU. `input`:
/// the file's name for errors.
[[nodiscard]] bool set_imu_rate(double rate_hz, const std::string& input, Rig& rig, Diagnostics& diagnostics);

/// Converts the noise values of the rig's IMUs to densities (standard deviations in continuous time) and adds a note. `kind`:
/// the present meaning of the values. `input`: the file's name for errors. False, with an error, if there is no IMU, or if an
/// IMU has no rate although the conversion of discrete noise needs one.
[[nodiscard]] bool make_densities(NoiseKind kind, const std::string& input, Rig& rig, Diagnostics& diagnostics);

}  // namespace fca
