// SPDX-License-Identifier: BSD-3-Clause
// What a file calls a fact of its rig.
#pragma once

#include <fca/formats/calibration.h>

#include <cstddef>
#include <string>

namespace fca {

/// The file's key of the pose that is rig.poses[index]: "IMU.T_b_c1", "cam0 T_cam_imu"; empty where the file specifies it in no
/// place of its own.
[[nodiscard]] std::string key_of_pose(const Calibration& calibration, std::size_t index);

}  // namespace fca
