// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/first_camera.h>

#include <algorithm>
#include <iterator>

namespace fca {

std::vector<PoseEdge> poses_of_first(const Rig& rig) {
  const std::string& first = rig.cameras.front().name;
  std::vector<PoseEdge> poses;
  const auto add = [&](const std::string& frame) {
    const bool known = std::ranges::any_of(poses, [&](const PoseEdge& pose) { return pose.a == frame || pose.b == frame; });
    if (frame == first || known) return;
    const bool camera = rig.find_camera(frame) != nullptr;
    const std::optional<Transform> T = camera ? rig.resolve(frame, first) : rig.resolve(first, frame);
    if (T) poses.push_back(camera ? PoseEdge{frame, first, *T} : PoseEdge{first, frame, *T});
  };
  for (const Camera& camera : rig.cameras) add(camera.name);
  for (const PoseEdge& edge : rig.poses) {
    add(edge.a);
    add(edge.b);
  }
  std::ranges::copy_if(rig.poses, std::back_inserter(poses),
                       [&](const PoseEdge& edge) { return !rig.resolve(edge.a, first) && !rig.resolve(edge.b, first); });
  return poses;
}

}  // namespace fca
