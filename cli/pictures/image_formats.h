// SPDX-License-Identifier: BSD-3-Clause
// Which image files are written, and what they can hold: nothing is to be lost silently.
#pragma once

#include <fca/toolkit/image.h>

#include <optional>
#include <string>
#include <string_view>

namespace fca::cli {

/// Is the extension (with its point, in any case) one of an image that is read and written?
[[nodiscard]] bool is_image_extension(std::string_view extension);

/// Why an image cannot be written as a file of that extension without a loss, in a sentence; nothing if it can.
[[nodiscard]] std::optional<std::string> problem_with_format(const Image& image, std::string_view extension);

/// ".png, .tif ..."
[[nodiscard]] std::string image_extensions();

}  // namespace fca::cli
