// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/remap/image_map.h>
#include <fca/rig/rig.h>

#include <cstddef>

namespace fca {

/// Computes the whole map in bands of rows. `jobs`: number of bands that are computed at the same time (0: number of
/// processors).
[[nodiscard]] ImageMap compute_map(const ImageMapper& mapper, std::size_t jobs);

/// The largest width or height of an image. cv::remap stores pixel coordinates as signed 16-bit numbers, and refuses images of
/// 32,767 px.
inline constexpr int kLongestSidePx = 32766;

/// True if images of the camera's size are small enough for cv::remap and for memory. If not, or if the size is unknown, adds
/// an error.
[[nodiscard]] bool fits_cv_remap(const Camera& camera, Diagnostics& diagnostics);

}  // namespace fca
