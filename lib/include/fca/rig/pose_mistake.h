// SPDX-License-Identifier: BSD-3-Clause
// The common mistakes by which a pose becomes another one.
#pragma once

#include <fca/message.h>
#include <fca/rig/transform.h>

#include <optional>
#include <span>

namespace fca {

/// A common mistake that turns one statement of a pose into another.
struct PoseMistake {
  Code code;                                                  ///< What the file does instead, and the fix; {0}: "T_a_b".
  std::optional<Transform> (*undo)(const Transform& stated);  ///< The pose as it should be.
};

[[nodiscard]] std::span<const PoseMistake> pose_mistakes();

/// The code of the one whose undoing makes `meant` of `stated`, within what poses that were estimated apart differ by; kNone:
/// none does.
[[nodiscard]] Code mistake_in(const Transform& stated, const Transform& meant);

}  // namespace fca
