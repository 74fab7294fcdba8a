// SPDX-License-Identifier: BSD-3-Clause
// What no fit of a model can do better, found in a hundredth of a fit's time.
#pragma once

#include <fca/rig/rig.h>

#include <optional>
#include <string_view>

namespace fca {

/// A lower limit [px] of the root mean square error of any camera of that model, over the camera's whole image or the part of
/// it within `max_angle_rad` and the lens circle. For models whose pixels are linear in all but fy / fx (model_traits.h:
/// kTerms): the least squares with coefficients of u and v of their own, which are more free than the parameters. The mean is
/// that of a grid of 12 x 12 pixels. Nothing for other models, for cameras without an image size or with rays alone, and where
/// a ray can have no pixel in the model.
[[nodiscard]] std::optional<double> least_rms_px(const Camera& camera, std::string_view model_id,
                                                 std::optional<double> max_angle_rad);

}  // namespace fca
