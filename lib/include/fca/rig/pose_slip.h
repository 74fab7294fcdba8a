// SPDX-License-Identifier: BSD-3-Clause
// The slips of the pen by which a pose becomes another one.
#pragma once

#include <fca/rig/transform.h>

#include <optional>
#include <span>
#include <string_view>

namespace fca {

/// A slip of the pen that turns one statement of a pose into another.
struct PoseSlip {
  std::string_view code;  ///< "pose-inverted", "pose-transposed", "translation-in-mm"
  std::string_view does;  ///< What the file does instead, behind "T_a_b ".
  std::string_view fix;
  std::optional<Transform> (*undo)(const Transform& stated);  ///< The pose as it should be.
};

[[nodiscard]] std::span<const PoseSlip> pose_slips();

}  // namespace fca
