// SPDX-License-Identifier: BSD-3-Clause
// How WoodScape's numbers and ours map onto each other.
#pragma once

#include <fca/rig/rig.h>

#include <array>
#include <string_view>

namespace fca::woodscape {

/// The frame of the poses.
inline constexpr std::string_view kVehicle = "vehicle";
/// SynWoodScape's key in place of "translation".
inline constexpr std::string_view kCarlaTranslation = "translation used in CARLA (CARLA reference)";
/// Keys of intrinsic that are parameters by their own name.
inline constexpr std::array<std::string_view, 5> kParameterKeys = {"k1", "k2", "k3", "k4", "aspect_ratio"};

/// The principal point's coordinate; `size`: width for cx, height for cy.
[[nodiscard]] double centre_of(double offset, int size);
/// The offset from which centre_of makes exactly that coordinate. Where no double does (a centre far to the left of the image's
/// middle has finer digits than its offset), the nearest.
[[nodiscard]] double offset_of(double centre, int size);

/// x y z w, as scipy's Rotation.from_quat reads it.
using Quaternion = std::array<double, 4>;

/// T_vehicle_camera. The quaternion need not be of unit length, but not be 0.
[[nodiscard]] Transform pose_of(const Quaternion& quaternion, const std::array<double, 3>& translation);
/// The unit quaternion with w >= 0 of the rotation nearest to the pose's.
[[nodiscard]] Quaternion quaternion_of(const Transform& T);
[[nodiscard]] std::array<double, 3> translation_of(const Transform& T);

}  // namespace fca::woodscape
