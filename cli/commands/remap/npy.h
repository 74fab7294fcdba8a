// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/remap/image_map.h>

#include <string>

namespace fca::cli {

/// The bytes of a NumPy file (format 1.0, numpy.lib.format) of a map: float32, shape (height, width, 2), u before v.
[[nodiscard]] std::string npy(const ImageMap& map);

}  // namespace fca::cli
