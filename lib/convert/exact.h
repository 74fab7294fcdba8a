// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <optional>
#include <string_view>

namespace fca::internal {

/// Of the model that has a skew besides (skewed.h); the id itself of any other.
[[nodiscard]] std::string_view id_without_skew(std::string_view id);

/// The same camera in another model, by closed forms (lib/models/exact_steps.h); nothing where a fit is needed.
[[nodiscard]] std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id);

/// A camera of the outer model (which contains the inner one's) that is that camera: convert_exactly or, where only a limit of
/// the outer model is (mei of ucm with alpha = 1), the furthest that a fit may go towards it.
[[nodiscard]] std::optional<CameraModel> convert_nearly(const CameraModel& inner, std::string_view outer_id);

/// The id of the largest model that the model of that id contains for all of its parameters (but alpha = 1 in mei:
/// convert_nearly); empty if there is none.
[[nodiscard]] std::string_view contained_model(std::string_view id);

}  // namespace fca::internal
