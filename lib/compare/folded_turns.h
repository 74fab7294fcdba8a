// SPDX-License-Identifier: BSD-3-Clause
// Turns of cameras that poses cancel: lens and poses differ by the same turn, and the world looks the same.
#pragma once

#include "pose_comparison.h"

#include <fca/compare/report.h>
#include <fca/rig/rig.h>

#include <optional>

namespace fca::internal {

/// Finds the cameras of `result` whose best rotation R (CameraComparison::rotated) explains most of what their rays differ by,
/// and whose poses differ by the same R: other.T_cam_x = R reference.T_cam_x. A pose between two such cameras has a turn of
/// each. Sets turn_cancels, and PoseComparison::remaining of their poses, and returns the reference as it is with these turns;
/// nothing where there is none. `result` has the comparisons of cameras and poses.
[[nodiscard]] std::optional<Rig> fold_turns(const PoseTask& poses, RigComparison& result);

}  // namespace fca::internal
