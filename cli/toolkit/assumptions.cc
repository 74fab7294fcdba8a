// SPDX-License-Identifier: BSD-3-Clause
#include "assumptions.h"

#include <algorithm>

namespace fca::cli {

bool has_assumed_unit(const PoseEdge& edge, const Calibration& calibration) {
  return std::ranges::find(calibration.poses_without_unit, edge.T_a_b, &PoseEdge::T_a_b) !=
         calibration.poses_without_unit.end();
}

void list_assumed_units(const Calibration& calibration, const Format& to, Written& written) {
  if (to.any_length_unit || !to.extrinsics) return;
  const Rig& rig = calibration.rig;
  const bool posed = std::ranges::any_of(rig.cameras, [&rig](const Camera& camera) {
    return camera.name != rig.cameras.front().name && rig.resolve(camera.name, rig.cameras.front().name);
  });
  if (posed && !calibration.poses_without_unit.empty())
    written.defaults.push_back({"translation unit", "taken as metres", true});
}

}  // namespace fca::cli
