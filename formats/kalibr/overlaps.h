// SPDX-License-Identifier: BSD-3-Clause
// cam_overlaps: the numbers of the cameras that see something in common with one. A Rig has no member for it; a chain whose
// cameras come, go or change places counts them again.
#pragma once

#include "../fields.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fca::kalibr {

inline constexpr std::string_view kOverlaps = "cam_overlaps";

/// What the camera `name` of `base` says, in the numbers of the cameras `after` (by their names in the base): those that are
/// gone are left out. Nothing if it says nothing, or no list of numbers of cameras.
[[nodiscard]] std::optional<fields::Field> overlaps_among(const text::Document& base, const std::string& name,
                                                          const Rig& after);

/// The same of a camera that no base has, from what was read of it (Rig::extra_fields): "[1]" speaks of cam1, by that
/// name in `after`.
[[nodiscard]] std::optional<fields::Field> overlaps_read(const Rig& read, const std::string& name, const Rig& after);

/// Does `field`, made of it, speak of every camera that `extra` speaks of?
[[nodiscard]] bool is_whole(const std::optional<fields::Field>& field, const ExtraField& extra);

/// Is that, of Rig::extra_fields, a camera's cam_overlaps?
[[nodiscard]] bool is_overlaps(const ExtraField& extra);

}  // namespace fca::kalibr
