// SPDX-License-Identifier: BSD-3-Clause
// How WoodScape's numbers and ours map onto each other.
#pragma once

#include <fca/models/camera_model.h>

#include <array>
#include <string_view>

namespace fca::woodscape {

/// The frame of the poses.
inline constexpr std::string_view kVehicle = "vehicle";
/// SynWoodScape's key in place of "translation".
inline constexpr std::string_view kCarlaTranslation = "translation used in CARLA (CARLA reference)";
/// Keys of intrinsic that are parameters by their own name.
inline constexpr std::array<ParameterId, 5> kParameterKeys = {"k1", "k2", "k3", "k4", "aspect_ratio"};

/// The principal point's coordinate; `size`: width for cx, height for cy.
[[nodiscard]] double centre_of(double offset, int size);
/// The offset from which centre_of makes exactly that coordinate. Where no double does (a centre far to the left of the image's
/// middle has finer digits than its offset), the nearest.
[[nodiscard]] double offset_of(double centre, int size);

}  // namespace fca::woodscape
