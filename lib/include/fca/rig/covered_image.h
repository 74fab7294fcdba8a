// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rig/rig.h>

namespace fca {

/// Is it certain, by the rays of the image's four corners, that each of its pixels has a ray, and that none is further from the
/// axis than the furthest of the corners? True only of lenses that are round but for their two focal lengths: pixels that have
/// a ray fill an ellipse, angles grow outwards on it, and a rectangle whose corners lie in an ellipse lies in it. False of
/// others, and where a corner has no ray.
[[nodiscard]] bool is_surely_covered(const CameraModel& model, const ImageSize& size);

}  // namespace fca
