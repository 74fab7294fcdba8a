// SPDX-License-Identifier: BSD-3-Clause
// How numbers are said in files and messages.
#pragma once

#include <fca/rig/rig.h>

#include <string>

namespace fca {

inline constexpr double kDegreesPerRadian = 57.29577951308232;

/// An error in pixels: three significant digits, tiny ones as powers of ten: "0.113", "4e-14".
[[nodiscard]] std::string pixels(double value);
/// "640 x 480"
[[nodiscard]] std::string size_in_words(const ImageSize& size);

}  // namespace fca
