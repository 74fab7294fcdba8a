// SPDX-License-Identifier: BSD-3-Clause
// Texts for the comments that the toolkit writes into files.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// A number of pixels with three significant digits; tiny numbers as powers of ten: "0.113", "4e-14". Above 1e6: "over a
/// million".
[[nodiscard]] std::string pixels(double value);
/// The name of a camera in the written file, with its name in the input if that is different: "cam0" or "cam0 (input's cam1)".
[[nodiscard]] std::string name_in_words(const ConvertedCamera& camera);
/// A size in pixels: "640 x 480".
[[nodiscard]] std::string size_in_words(const ImageSize& size);

}  // namespace fca
