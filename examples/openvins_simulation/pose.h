// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace flight {

/// Where the IMU is at a time.
struct Pose {
  double time = 0.0;            ///< s
  Eigen::Matrix3d R_world_imu;  ///< World: z up.
  Eigen::Vector3d p_world_imu;  ///< m
};

}  // namespace flight
