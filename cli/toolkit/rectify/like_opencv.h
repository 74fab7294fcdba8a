// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/rectify.h>

namespace fca {

/// Rectifies the pair with OpenCV. `size`: size [px] of the rectified images. `alpha`: OpenCV's free scaling parameter, from 0
/// (only valid pixels) to 1 (all pixels of the original images). nullopt, with an error, if OpenCV does not support the lens
/// models of these cameras, or if its rectification fails.
[[nodiscard]] std::optional<RectifiedPair> rectify_with_opencv(const OpenCvRectifier& opencv,
                                                               const std::array<Camera, 2>& cameras,
                                                               const Transform& T_second_first, double alpha,
                                                               const ImageSize& size, Diagnostics& diagnostics);

}  // namespace fca
