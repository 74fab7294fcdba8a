// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <array>

namespace fca {

/// The coefficients of OCamCalib's direct polynomial, by their power of rho.
inline constexpr std::array<ParameterId, 9> kOcamcalibCoefficients = {"a0", "a1", "a2", "a3", "a4", "a5", "a6", "a7", "a8"};

}  // namespace fca
