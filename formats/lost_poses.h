// SPDX-License-Identifier: BSD-3-Clause
// Which poses of a rig do not survive being written: found in the files themselves, so that no writer keeps a list.
#pragma once

#include <fca/formats/format.h>

#include <vector>

namespace fca {

/// The poses that the files specify, between cameras by the rig's names.
[[nodiscard]] std::vector<PoseEdge> poses_in(const Format& format, const Written& written);

/// A loss "pose-dropped" for every stated pose of `rig` that the files written (Written::poses) neither specify nor imply.
/// Poses between the same two groups of frames, each of which is kept, are one loss: the cameras' in the vehicle. A frame that
/// is no camera and no IMU and sits exactly where another does (OpenCV's reference) is that one by another name.
[[nodiscard]] std::vector<Loss> lost_poses(const Format& format, const Rig& rig, const Written& written);

}  // namespace fca
