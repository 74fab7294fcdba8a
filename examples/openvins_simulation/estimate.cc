// SPDX-License-Identifier: BSD-3-Clause
#include "estimate.h"

#include <core/VioManager.h>
#include <state/State.h>

#include <memory>

namespace flight {

std::vector<Pose> estimate(const Flight& flight, const std::string& config) {
  ov_msckf::VioManagerOptions options = read_options(config);
  ov_msckf::VioManager estimator(options);
  estimator.initialize_with_gt(flight.start);

  std::vector<Pose> poses;
  auto images = flight.images.begin();
  for (const ov_core::ImuData& imu : flight.imu) {
    estimator.feed_measurement_imu(imu);
    // The estimator propagates to an image's time by measurements on both sides of it.
    for (; images != flight.images.end() && images->time < imu.timestamp; ++images) {
      estimator.feed_measurement_simulation(images->time, images->cameras, images->points);
      const auto state = estimator.get_state();
      poses.push_back({images->time, state->_imu->Rot().transpose(), state->_imu->pos()});
    }
  }
  return poses;
}

}  // namespace flight
