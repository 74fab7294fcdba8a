// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/remap/image_map.h>
#include <fca/rig/rig.h>

#include <cstddef>

namespace fca {

/// Computes the whole map, in bands of rows of which up to `jobs` are computed at the same time (0: as many as processors).
[[nodiscard]] ImageMap compute_map(const ImageMapper& mapper, std::size_t jobs);

/// The largest width or height of an image: cv::remap stores pixel coordinates in 16 bits with a sign, and takes no image of
/// 32,767 px.
inline constexpr int kLongestSidePx = 32766;

/// Whether images of the camera's size are small enough for cv::remap and for memory; if not, or the size is not known, adds an
/// error.
[[nodiscard]] bool fits_cv_remap(const Camera& camera, Diagnostics& diagnostics);

}  // namespace fca
