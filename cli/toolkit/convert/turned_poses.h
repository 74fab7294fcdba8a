// SPDX-License-Identifier: BSD-3-Clause
// Poses of cameras whose frames were turned by their fits (ConversionReport::turn).
#pragma once

#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// States the poses, and a pair's rectification, in the cameras' new frames.
void turn_poses(const std::vector<ConvertedCamera>& cameras, Rig& rig);

/// Says which cameras were turned, which of those have no pose in the written files, and for which a turn would help.
void tell_of_turns(const std::vector<PoseEdge>& written, const std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
