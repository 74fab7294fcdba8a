// SPDX-License-Identifier: BSD-3-Clause
// What no fit of a model can do better, found in a hundredth of a fit's time.
#pragma once

#include <fca/rig/rig.h>

#include <optional>
#include <string_view>

namespace fca {

/// A limit [px] below which the root mean square error of no camera of that model comes over the camera's whole image, or what
/// of it lies within `max_angle_rad` and the lens circle. Of pinhole and radtan, whose pixels are linear in numbers that are
/// more free than their parameters: the least squares of these. The mean is that of some hundred pixels. Nothing of other
/// models, of cameras without an image size or with rays alone, and where a ray lies 90 degrees or more from the axis.
[[nodiscard]] std::optional<double> least_rms_px(const Camera& camera, std::string_view model_id,
                                                 std::optional<double> max_angle_rad);

}  // namespace fca
