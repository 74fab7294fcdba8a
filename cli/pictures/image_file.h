// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/toolkit/image.h>

#include <optional>
#include <string>

namespace fca::cli {

/// The image of a file; nothing with an error where there is none, or only a part of one.
[[nodiscard]] std::optional<Image> read_image_file(const std::string& path, Diagnostics& diagnostics);

}  // namespace fca::cli
