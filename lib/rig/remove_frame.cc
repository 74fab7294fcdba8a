// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/remove_frame.h>

#include <utility>
#include <vector>

namespace fca {

void remove_frame(std::string_view frame, Rig& rig) {
  Rig others;
  std::vector<std::string> neighbours;
  for (const PoseEdge& edge : rig.poses) {
    if (edge.a != frame && edge.b != frame) {
      others.poses.push_back(edge);
    } else {
      neighbours.push_back(edge.a == frame ? edge.b : edge.a);
    }
  }
  for (const std::string& neighbour : neighbours) {
    const std::string& first = neighbours.front();
    if (others.resolve(neighbour, first)) continue;
    if (const std::optional<Transform> T = rig.resolve(neighbour, first)) others.poses.push_back({neighbour, first, *T});
  }
  rig.poses = std::move(others.poses);
}

}  // namespace fca
