// SPDX-License-Identifier: BSD-3-Clause
// A fit may rotate the frame of a camera (ConversionReport::turn). The poses of such cameras are changed accordingly.
#pragma once

#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// Changes the poses of `rig`, and the rotations of its rectified pair, so that they are those of the rotated camera frames.
void turn_poses(const std::vector<ConvertedCamera>& cameras, Rig& rig);

/// Adds a note about each rotated camera, which also says whether the written files contain a pose for the rotation, and about
/// each camera with a pose that a rotation would improve. Removes the offers (ConversionReport::turn_offer) of cameras without
/// a pose, which could not hold the rotation. `written`: the poses in the written files.
void report_turns(const std::vector<PoseEdge>& written, std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
