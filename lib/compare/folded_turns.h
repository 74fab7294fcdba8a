// SPDX-License-Identifier: BSD-3-Clause
// Turns of cameras that poses cancel: lens and poses differ by the same turn, and the world looks the same.
#pragma once

#include "pose_comparison.h"

#include <fca/compare/report.h>
#include <fca/rig/rig.h>

#include <optional>
#include <vector>

namespace fca::internal {

/// A turn of a lens.
struct LensTurn {
  BestRotation rotation;
  std::optional<CameraDifference> in_focus;  ///< The differences that it leaves of the rays in focus, where some are.
};

/// Makes it the turn of that comparison.
void set_turn(const LensTurn& turn, CameraComparison& camera);

/// Finds the cameras of `result` whose turn R explains most of what their rays differ by, and whose poses differ by the same
/// R: other.T_cam_x = R reference.T_cam_x. A pose between two such cameras has a turn of each. Sets turn_cancels and the turn
/// itself of these cameras, and PoseComparison::remaining of their poses. Returns the reference as it is with these turns;
/// nothing where there is none. `turns`: of the whole lens of each camera of `result`, of points infinitely far away.
[[nodiscard]] std::optional<Rig> fold_turns(const PoseTask& poses, const std::vector<std::optional<LensTurn>>& turns,
                                            RigComparison& result);

}  // namespace fca::internal
