// SPDX-License-Identifier: BSD-3-Clause
// Poses of cameras whose frames were rotated by their fits (ConversionReport::turn).
#pragma once

#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// Converts the poses, and a pair's rectification, to the cameras' rotated frames.
void turn_poses(const std::vector<ConvertedCamera>& cameras, Rig& rig);

/// Adds notes about the cameras that were rotated, those of them that have no pose in the written files, and those that a
/// rotation would improve.
void report_turns(const std::vector<PoseEdge>& written, const std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
