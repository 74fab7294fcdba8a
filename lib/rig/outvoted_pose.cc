// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/contradictions.h>
#include <fca/rig/outvoted_pose.h>
#include <fca/rig/stereo_order.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <set>
#include <vector>

namespace fca {

namespace {

/// Are the first two cameras a stereo pair in its usual order?
bool is_left_of_second(const Rig& rig) {
  return rig.cameras.size() > 1 && may_be_stereo(rig, rig.cameras[0], rig.cameras[1]) && !second_left_of_first(rig) &&
         !second_below_first(rig);
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
  for (const std::size_t edge : edges_of(loops)) {
    const Rig others = without_pose(edge, rig);
    const std::optional<Transform> around = others.resolve(rig.poses[edge].a, rig.poses[edge].b);
    if (around && contradictions(others).empty()) candidates.push_back({edge, *around});
  }
  if (candidates.size() > 1) {
    std::erase_if(candidates, [&rig](const OutvotedPose& pose) { return !is_left_of_second(without_pose(pose.edge, rig)); });
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
