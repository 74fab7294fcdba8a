// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "image.h"

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <optional>
#include <string>

namespace fca::cli {

/// The image of a file; nothing with an error where there is none, or only a part of one.
[[nodiscard]] std::optional<Image> read_image(const std::string& path, Diagnostics& diagnostics);

/// An error, with how to mend it, unless the image is of the size for which the camera is known. `changed`: that is not the
/// calibrated one (--crop, --binning, --resize).
[[nodiscard]] bool has_size_of(const Camera& camera, bool changed, const Image& image, const std::string& path,
                               Diagnostics& diagnostics);

}  // namespace fca::cli
