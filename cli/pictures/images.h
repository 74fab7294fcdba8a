// SPDX-License-Identifier: BSD-3-Clause
// Private: the module's functions of images, as pictures.h describes them.
#pragma once

#include "pictures.h"

#include <optional>
#include <string>

namespace fca::cli::module {

[[nodiscard]] std::optional<Image> decoded_image(const std::string& bytes);
[[nodiscard]] std::optional<std::string> encoded_image(const Image& image, const std::string& extension);

}  // namespace fca::cli::module
