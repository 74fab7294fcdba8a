// SPDX-License-Identifier: BSD-3-Clause
#include "assumptions.h"

#include <fca/code.h>

#include <algorithm>

namespace fca {

void list_assumed_units(const Calibration& calibration, const Format& to, Written& written) {
  if (to.leaves_unit_open() || !to.extrinsics) return;
  const Rig& rig = calibration.rig;
  std::size_t held = 0;
  for (const Written::File& file : written.files) held += file.cameras.size();
  // A pose between cameras needs two of them in the files, a pose in the IMU needs one.
  const bool posed = std::ranges::any_of(rig.poses, [&rig, held](const PoseEdge& pose) {
    const bool has_imu =
        std::ranges::any_of(rig.imus, [&pose](const Imu& imu) { return imu.name == pose.a || imu.name == pose.b; });
    return has_imu ? held > 0 : held > 1;
  });
  if (posed && !calibration.poses_without_unit.empty())
    written.defaults.push_back({"translation unit", Message{Code::kTakenAsMetres}, true, true});
}

}  // namespace fca
