// SPDX-License-Identifier: BSD-3-Clause
// Conversions between camera models without a fit.
#pragma once

#include <fca/models/camera_model.h>

#include <optional>
#include <string_view>

namespace fca::internal {

/// The id of the same model without skew, if the model `id` has a skew parameter (skewed.h). Otherwise `id` itself.
[[nodiscard]] std::string_view id_without_skew(std::string_view id);

/// The same camera in another model: every ray has the same pixel (up to rounding). Uses the closed forms of
/// lib/models/exact_steps.h. nullopt if there is no closed form for these parameters, so that a fit is needed.
[[nodiscard]] std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id);

/// The camera `inner` in the model `outer_id`, which contains the camera's model. mei contains ucm with alpha = 1 only in the
/// limit of infinite xi: the result then has the largest xi that fits use, and is not exact. nullopt as for convert_exactly().
[[nodiscard]] std::optional<CameraModel> convert_nearly(const CameraModel& inner, std::string_view outer_id);

/// The largest model that the model `id` contains: each of its cameras is also a camera of the model `id` (for ucm in mei, see
/// convert_nearly()). Empty if the model contains no other.
[[nodiscard]] std::string_view contained_model(std::string_view id);

}  // namespace fca::internal
