// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rig/rig.h>

#include <cstddef>
#include <optional>

namespace fca {

/// The one pose of a rig that is wrong where poses contradict each other.
struct OutvotedPose {
  std::size_t edge = 0;   ///< In Rig::poses.
  Transform T_a_b;        ///< What the others say of it.
  bool by_order = false;  ///< Others alone would do, too, but leave the second camera on the left of the first.
};

/// Nothing where no poses contradict each other, where leaving out one is not enough, and where leaving out any of several
/// would be.
[[nodiscard]] std::optional<OutvotedPose> outvoted_pose(const Rig& rig);

/// The rig without one of its poses, by its place in Rig::poses.
[[nodiscard]] Rig without_pose(std::size_t edge, Rig rig);

}  // namespace fca
