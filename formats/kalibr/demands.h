// SPDX-License-Identifier: BSD-3-Clause
// What Kalibr demands of models beyond their own ranges (ConfigReader.py: 0 <= alpha < 1; a radtan has four coefficients).
#pragma once

#include <fca/convert/parameter_range.h>

#include <array>
#include <limits>
#include <string_view>

namespace fca::kalibr {

inline constexpr double kBelowOne = 1.0 - std::numeric_limits<double>::epsilon() / 2;
inline constexpr std::array kAlphaRange = {ParameterRange{"alpha", 0.0, kBelowOne}};
inline constexpr std::array kNoK3 = {ParameterRange{"k3", 0.0, 0.0}};

}  // namespace fca::kalibr
