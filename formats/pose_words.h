// SPDX-License-Identifier: BSD-3-Clause
// Angles and lengths as messages say them.
#pragma once

#include <fca/code.h>
#include <fca/message.h>

#include <cmath>
#include <numbers>

namespace fca {

/// Rounding is no difference: 6.8e-14 deg reads as 0.
inline double without_rounding(double value) { return std::abs(value) < 1e-9 ? 0.0 : value; }

inline double in_degrees(double radians) { return without_rounding(radians) * 180.0 / std::numbers::pi; }

/// "12.5 mm", "0.52 m"
inline Message in_metres(double value) {
  constexpr double kShort = 0.1;
  const double metres = without_rounding(value);
  return std::abs(metres) < kShort ? Message{Code::kInMillimetres, {metres * 1000.0}} : Message{Code::kInMetres, {metres}};
}

}  // namespace fca
