// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rig/rig.h>

namespace fca {

/// True if the rays of the image's four corners prove that each of its pixels has a ray, and that no ray is further from the
/// axis than the furthest of the corners'. Only round models (kRound in model_traits.h) allow that: their pixels with a ray
/// fill an ellipse, in which angles grow outwards, and a rectangle whose corners lie in an ellipse lies in it. False for other
/// models, and if a corner has no ray.
[[nodiscard]] bool is_surely_covered(const CameraModel& model, const ImageSize& size);

}  // namespace fca
