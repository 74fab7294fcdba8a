// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/remap/image_map.h>
#include <fca/rig/rig.h>

#include <cstddef>

namespace fca {

/// All rows of a map, up to `jobs` pieces at the same time.
[[nodiscard]] ImageMap map_of(const ImageMapper& mapper, std::size_t jobs);

/// cv::remap counts in 16 bits.
inline constexpr int kLongestSide = 32766;

/// Can images of the camera's size be mapped? Else an error.
[[nodiscard]] bool sides_are_mapped(const Camera& camera, Diagnostics& diagnostics);

}  // namespace fca
