// SPDX-License-Identifier: BSD-3-Clause
#include "assumptions.h"

#include <fca/code.h>

#include <algorithm>

namespace fca {

void list_assumed_units(const Calibration& calibration, const Format& to, Written& written) {
  if (to.leaves_unit_open() || !to.extrinsics) return;
  const Rig& rig = calibration.rig;
  std::size_t written_cameras = 0;
  for (const Written::File& file : written.files) written_cameras += file.cameras.size();
  // The files contain a pose between two cameras only if both are in the files, and a pose of the IMU if one camera is.
  const bool has_pose = std::ranges::any_of(rig.poses, [&rig, written_cameras](const PoseEdge& pose) {
    const bool has_imu =
        std::ranges::any_of(rig.imus, [&pose](const Imu& imu) { return imu.name == pose.a || imu.name == pose.b; });
    return has_imu ? written_cameras > 0 : written_cameras > 1;
  });
  if (has_pose && !calibration.poses_without_unit.empty())
    written.defaults.push_back({"translation unit", Message{Code::kTakenAsMetres}, true, true});
}

}  // namespace fca
