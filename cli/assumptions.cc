// SPDX-License-Identifier: BSD-3-Clause
#include "assumptions.h"

#include <algorithm>

namespace fca::cli {

void list_assumed_units(const Calibration& calibration, const Format& to, Written& written) {
  if (!calibration.format->any_length_unit || to.id == calibration.format->id || !to.extrinsics) return;
  const Rig& rig = calibration.rig;
  const bool posed = std::ranges::any_of(rig.cameras, [&rig](const Camera& camera) {
    return camera.name != rig.cameras.front().name && rig.resolve(camera.name, rig.cameras.front().name);
  });
  if (posed) written.defaults.push_back({"translation unit", "taken as metres", true});
}

}  // namespace fca::cli
