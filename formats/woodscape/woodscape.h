// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../schema/schema.h"

namespace fca::woodscape {

extern const Format kFormat;
extern const schema::Schema kSchema;

extern const schema::PoseLayout kPoseInVehicle;
/// The row of extrinsic.
[[nodiscard]] const schema::Key& pose_key();

inline constexpr std::string_view kModel = "radial_poly";
/// SynWoodScape's key in place of "translation".
inline constexpr std::string_view kCarlaTranslation = "translation used in CARLA (CARLA reference)";
/// Of equal keys Python's json takes the last, as PyYAML does.
inline constexpr text::Dialect kDialect = text::Dialect::kPyYaml;

}  // namespace fca::woodscape
