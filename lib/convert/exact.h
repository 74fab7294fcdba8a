// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <optional>
#include <string_view>

namespace fca::internal {

/// For a model with a skew parameter (skewed.h), the id of the same model without skew; for any other, `id` itself.
[[nodiscard]] std::string_view id_without_skew(std::string_view id);

/// The camera in another model, with the same pixel for every ray, by closed forms (lib/models/exact_steps.h). Nothing if there
/// is no closed form for these parameters, so that a fit is needed.
[[nodiscard]] std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id);

/// The camera in a model that contains its model. If that model reaches it only in a limit (mei reaches ucm with alpha = 1 as
/// xi grows without end), the camera at the bound that fits have there.
[[nodiscard]] std::optional<CameraModel> convert_nearly(const CameraModel& inner, std::string_view outer_id);

/// The model with the most parameters among those of which the model `id` can hold every camera (in mei, ucm with alpha = 1
/// only nearly: convert_nearly). Empty if it contains no other.
[[nodiscard]] std::string_view contained_model(std::string_view id);

}  // namespace fca::internal
