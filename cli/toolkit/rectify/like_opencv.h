// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/rectify.h>

namespace fca {

/// Rectifies the pair with OpenCV. nullopt, with an error, if OpenCV does not have such lenses, or throws. `alpha`: 0 to 1.
[[nodiscard]] std::optional<RectifiedPair> rectified_by(const OpenCvRectifier& opencv, const std::array<Camera, 2>& cameras,
                                                        const Transform& T_second_first, double alpha, const ImageSize& size,
                                                        Diagnostics& diagnostics);

}  // namespace fca
