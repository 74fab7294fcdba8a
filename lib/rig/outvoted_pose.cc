// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/contradictions.h>
#include <fca/rig/outvoted_pose.h>
#include <fca/rig/stereo_order.h>

#include <algorithm>
#include <set>
#include <vector>

namespace fca {

namespace {

/// The poses of the contradicting loops, each of which may be the wrong one.
std::set<std::size_t> suspects(const std::vector<PoseLoop>& loops) {
  std::set<std::size_t> edges;
  for (const PoseLoop& loop : loops) {
    edges.insert(loop.edge);
    edges.insert(loop.path.begin(), loop.path.end());
  }
  return edges;
}

/// But for the digits that were not printed.
bool is_rotation(const PoseEdge& edge) {
  constexpr double kPrintedWithTwoDigits = 2e-2;
  return rotation_determinant(edge.T_a_b) > 0.0 && rotation_defect(edge.T_a_b) <= kPrintedWithTwoDigits;
}

}  // namespace

std::optional<OutvotedPose> outvoted_pose(const Rig& rig) {
  const std::vector<PoseLoop> loops = contradictions(rig);
  if (loops.empty() || !std::ranges::all_of(rig.poses, is_rotation)) return std::nullopt;
  std::vector<OutvotedPose> candidates;
  for (const std::size_t edge : suspects(loops)) {
    const Rig others = without_pose(edge, rig);
    const std::optional<Transform> around = others.resolve(rig.poses[edge].a, rig.poses[edge].b);
    if (around && contradictions(others).empty()) candidates.push_back({edge, *around});
  }
  if (candidates.size() > 1) {
    std::erase_if(candidates,
                  [&rig](const OutvotedPose& pose) { return second_left_of_first(without_pose(pose.edge, rig)).has_value(); });
    for (OutvotedPose& pose : candidates) pose.by_order = true;
  }
  if (candidates.size() != 1) return std::nullopt;
  return candidates.front();
}

Rig without_pose(std::size_t edge, Rig rig) {
  rig.poses.erase(rig.poses.begin() + static_cast<std::ptrdiff_t>(edge));
  return rig;
}

}  // namespace fca
