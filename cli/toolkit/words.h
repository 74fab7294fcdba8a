// SPDX-License-Identifier: BSD-3-Clause
// How numbers are said in files and messages.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

#include <optional>
#include <string>

namespace fca {

inline constexpr double kDegreesPerRadian = 57.29577951308232;

/// An error in pixels: three significant digits, tiny ones as powers of ten: "0.113", "4e-14".
[[nodiscard]] std::string pixels(double value);
/// The same between pixels of an image: "over 905" where none are so far apart.
[[nodiscard]] std::string pixels(double value, const std::optional<ImageSize>& image);
/// "cam0", or "cam0 (input's cam1)" where the file written calls a camera otherwise than the input.
[[nodiscard]] std::string name_in_words(const ConvertedCamera& camera);
/// "640 x 480"
[[nodiscard]] std::string size_in_words(const ImageSize& size);

}  // namespace fca
