// SPDX-License-Identifier: BSD-3-Clause
// A flight that OpenVINS' simulator makes up: what the IMU and the cameras measure along a trajectory.
#pragma once

#include "pose.h"

#include <core/VioManagerOptions.h>
#include <utils/sensor_data.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flight {

/// What the cameras see at one time: for each camera the points' numbers and pixels.
struct Images {
  double time = 0.0;  ///< s
  std::vector<int> cameras;
  std::vector<std::vector<std::pair<std::size_t, Eigen::VectorXf>>> points;
};

struct Flight {
  Eigen::Matrix<double, 17, 1> start;  ///< True state at the first measurement, in OpenVINS' order.
  std::vector<ov_core::ImuData> imu;   ///< In order of time.
  std::vector<Images> images;          ///< In order of time.
  std::vector<Pose> truth;             ///< One for each of `images`.
};

struct FlightRequest {
  std::string config;      ///< estimator_config.yaml next to the true chains.
  std::string trajectory;  ///< A file "time x y z qx qy qz qw" (s, m).
  int seed = 0;            ///< Of the points, the noise and the biases.
};

/// OpenVINS' settings of a configuration, with online calibration and threads off. Ends the program if something is missing.
[[nodiscard]] ov_msckf::VioManagerOptions read_options(const std::string& config);

[[nodiscard]] Flight simulate(const FlightRequest& request);

/// Metres along the true poses.
[[nodiscard]] double length_of(const Flight& flight);

}  // namespace flight
