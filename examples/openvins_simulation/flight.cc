// SPDX-License-Identifier: BSD-3-Clause
#include "flight.h"

#include <sim/Simulator.h>
#include <utils/opencv_yaml_parse.h>
#include <utils/quat_ops.h>

#include <cstdlib>
#include <iostream>
#include <memory>

namespace flight {

ov_msckf::VioManagerOptions read_options(const std::string& config) {
  const auto parser = std::make_shared<ov_core::YamlParser>(config);
  ov_msckf::VioManagerOptions options;
  options.print_and_load(parser);
  options.print_and_load_simulation(parser);
  if (!parser->successful()) {
    std::cerr << config << " is incomplete\n";
    std::exit(EXIT_FAILURE);
  }
  ov_msckf::StateOptions& state = options.state_options;
  state.do_calib_camera_intrinsics = false;
  state.do_calib_camera_pose = false;
  state.do_calib_camera_timeoffset = false;
  state.do_calib_imu_intrinsics = false;
  state.do_calib_imu_g_sensitivity = false;
  options.num_opencv_threads = 0;
  options.use_multi_threading_pubs = false;
  options.use_multi_threading_subs = false;
  return options;
}

namespace {

Pose pose_of(const Eigen::Matrix<double, 17, 1>& state) {
  return {state(0), ov_core::quat_2_Rot(state.segment<4>(1)).transpose(), state.segment<3>(5)};
}

}  // namespace

Flight simulate(const FlightRequest& request) {
  ov_msckf::VioManagerOptions options = read_options(request.config);
  options.sim_traj_path = request.trajectory;
  options.sim_seed_state_init = request.seed;
  options.sim_seed_measurements = request.seed;
  options.sim_do_perturbation = false;
  ov_msckf::Simulator simulator(options);

  Flight flight;
  if (!simulator.get_state(simulator.current_timestamp() + 1.0 / options.sim_freq_imu, flight.start)) {
    std::cerr << request.trajectory << " is too short\n";
    std::exit(EXIT_FAILURE);
  }
  while (simulator.ok()) {
    ov_core::ImuData imu;
    if (simulator.get_next_imu(imu.timestamp, imu.wm, imu.am)) flight.imu.push_back(imu);
    Images images;
    if (simulator.get_next_cam(images.time, images.cameras, images.points)) flight.images.push_back(std::move(images));
  }
  // The last images have no measurement of the IMU after them.
  while (!flight.images.empty() && flight.images.back().time >= flight.imu.back().timestamp) flight.images.pop_back();
  for (const Images& images : flight.images) {
    Eigen::Matrix<double, 17, 1> state;
    if (!simulator.get_state(images.time, state)) std::exit(EXIT_FAILURE);
    flight.truth.push_back(pose_of(state));
  }
  return flight;
}

double length_of(const Flight& flight) {
  double length = 0.0;
  for (std::size_t i = 1; i < flight.truth.size(); ++i)
    length += (flight.truth[i].p_world_imu - flight.truth[i - 1].p_world_imu).norm();
  return length;
}

}  // namespace flight
