// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_cameras.h"

#include <fca/rig/stereo_pair.h>

#include <vector>

namespace fca {

std::optional<StereoCameras> stereo_cameras(const Rig& input, const std::vector<ConvertedCamera>& cameras) {
  Rig candidates;  // the cameras that can be rectified, with all poses
  candidates.poses = input.poses;
  std::vector<std::size_t> indices;  // the index in `cameras` of each candidate
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Camera& camera = cameras[i].source;
    const bool is_ray_table = !camera.rays.empty();  // has no formula, which a rectification needs
    if (is_ray_table || !camera.image_size) continue;
    candidates.cameras.push_back(camera);
    indices.push_back(i);
  }
  const auto pair = stereo_pair(candidates);
  if (!pair) return std::nullopt;
  const auto [first, second] = *pair;
  const std::optional<Transform> T_second_first =
      candidates.resolve(candidates.cameras[second].name, candidates.cameras[first].name);
  if (!T_second_first) return std::nullopt;
  return StereoCameras{indices[first], indices[second], *T_second_first};
}

}  // namespace fca
