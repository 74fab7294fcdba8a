// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pose.h"

#include <vector>

namespace flight {

struct TrajectoryError {
  double position_m = 0.0;       ///< rms
  double orientation_deg = 0.0;  ///< rms
};

/// Of estimated poses against true ones at the same times, after the turn about the vertical and the shift that bring the
/// positions nearest (Zhang and Scaramuzza, "A Tutorial on Quantitative Trajectory Evaluation", 2018, section IV-B): a camera
/// and an IMU observe everything but these four.
[[nodiscard]] TrajectoryError error_of(const std::vector<Pose>& estimate, const std::vector<Pose>& truth);

}  // namespace flight
