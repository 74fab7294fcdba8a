// SPDX-License-Identifier: BSD-3-Clause
// Texts that the toolkit puts into comments of files.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// An error in pixels with three significant digits, tiny ones as powers of ten: "0.113", "4e-14".
[[nodiscard]] std::string pixels(double value);
/// "cam0", or "cam0 (input's cam1)" if the written file has another name for the camera than the input.
[[nodiscard]] std::string name_in_words(const ConvertedCamera& camera);
/// A size in pixels as text: "640 x 480"
[[nodiscard]] std::string size_in_words(const ImageSize& size);

}  // namespace fca
