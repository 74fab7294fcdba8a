// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_cameras.h"

#include <fca/rig/stereo_pair.h>

#include <vector>

namespace fca {

std::optional<StereoCameras> stereo_cameras(const Rig& input, const std::vector<ConvertedCamera>& cameras) {
  Rig rig;
  rig.poses = input.poses;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Camera& source = cameras[i].source;
    if (!source.rays.empty() || !source.image_size) continue;
    rig.cameras.push_back(source);
    indices.push_back(i);
  }
  const auto places = stereo_pair(rig);
  if (!places) return std::nullopt;
  const std::optional<Transform> T = rig.resolve(rig.cameras[places->second].name, rig.cameras[places->first].name);
  return T ? std::optional(StereoCameras{indices[places->first], indices[places->second], *T}) : std::nullopt;
}

}  // namespace fca
