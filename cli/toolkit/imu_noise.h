// SPDX-License-Identifier: BSD-3-Clause
// --imu-noise: what the input's IMU noise is, where it is no density.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <string>
#include <string_view>

namespace fca::cli {

/// What the numbers of an IMU's noise may stand for.
struct NoiseKind {
  std::string_view name;  ///< As the option says it.
  bool discrete = false;  ///< Of single samples, not densities.
  bool variance = false;  ///< Squares.
};

/// The kind of that name; null if there is none.
[[nodiscard]] const NoiseKind* find_noise_kind(std::string_view name);

/// The rig's IMU noise as densities (standard deviations in continuous time), with a note; `input` is named in errors. False
/// with an error where there is no IMU, or no rate though single samples need one.
[[nodiscard]] bool make_densities(const NoiseKind& kind, const std::string& input, Rig& rig, Diagnostics& diagnostics);

}  // namespace fca::cli
