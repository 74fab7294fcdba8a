// SPDX-License-Identifier: BSD-3-Clause
#include "assumptions.h"

#include <fca/code.h>

#include <algorithm>

namespace fca {

void list_assumed_units(const Calibration& calibration, const Format& to, Written& written) {
  if (to.leaves_unit_open() || !to.extrinsics) return;
  const Rig& rig = calibration.rig;
  const bool posed = std::ranges::any_of(rig.cameras, [&rig](const Camera& camera) {
    return camera.name != rig.cameras.front().name && rig.resolve(camera.name, rig.cameras.front().name);
  });
  std::size_t held = 0;
  for (const Written::File& file : written.files) held += file.cameras.size();
  if (posed && held > 1 && !calibration.poses_without_unit.empty())
    written.defaults.push_back({"translation unit", Message{Code::kTakenAsMetres}, true, true});
}

}  // namespace fca
