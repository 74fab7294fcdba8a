// SPDX-License-Identifier: BSD-3-Clause
#include "folded_turns.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace fca::internal {

namespace {

struct TurnedCamera {
  CameraComparison* camera;
  const LensTurn* turn;
};

using Cameras = std::vector<TurnedCamera>;

/// A tenth of the rms and more: a model may be off by more than the turn.
bool explains_rays(const CameraComparison& camera, const LensTurn& turn) {
  constexpr double kExplainsRays = 0.9;
  const ErrorStatistics& left = turn.rotation.difference.statistics;
  return left.coverage.scored > 0.0 && left.error.rms < kExplainsRays * camera.difference.statistics.error.rms;
}

/// The reference with other frames of these cameras: those in which the other file has their lenses.
Rig with_turns(const Rig& reference, const Cameras& turned) {
  Rig rig = reference;
  for (const auto& [camera, turn] : turned) {
    const Transform& T_other_reference = turn->rotation.T_other_reference;
    const Transform T_reference_other = inverse(T_other_reference).value();
    for (PoseEdge& edge : rig.poses) {
      if (edge.a == camera->reference) edge.T_a_b = T_other_reference * edge.T_a_b;
      if (edge.b == camera->reference) edge.T_a_b = edge.T_a_b * T_reference_other;
    }
  }
  return rig;
}

/// The poses of that reference, in the order of the comparison of the other one.
std::vector<PoseComparison> compared_with(const Rig& reference, const PoseTask& poses) {
  RigComparison result;
  compare_poses({reference, poses.other, poses.matching}, result);
  return result.poses;
}

bool is_of(const PoseComparison& pose, const CameraComparison& camera) {
  return pose.a == camera.reference || pose.b == camera.reference;
}

/// How much of the camera's poses' differences remains with the turns taken out: the largest ratio of one of them; infinite
/// where none differs.
double remaining_share(const CameraComparison& camera, const std::vector<PoseComparison>& stated,
                       const std::vector<PoseComparison>& folded) {
  constexpr double kRounding = 1e-6;  // of what two honest calibrations may differ by
  double share = -1.0;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    if (!is_of(stated[i], camera)) continue;
    const double before = stated[i].apart();
    const double after = folded[i].apart();
    if (before <= kRounding && after <= kRounding) continue;
    share = std::max(share, before > kRounding ? after / before : std::numeric_limits<double>::infinity());
  }
  return share < 0.0 ? std::numeric_limits<double>::infinity() : share;
}

/// Those whose poses turn back. Of a pair one turn may be in its pose and the other not: the one that agrees least is taken
/// away until all agree.
Cameras cancelling(Cameras candidates, const PoseTask& poses, const std::vector<PoseComparison>& stated) {
  constexpr double kExplainsPoses = 0.35;
  while (!candidates.empty()) {
    const std::vector<PoseComparison> folded = compared_with(with_turns(poses.reference, candidates), poses);
    if (folded.size() != stated.size()) return {};
    const auto share = [&](const TurnedCamera& turned) { return remaining_share(*turned.camera, stated, folded); };
    const auto least = std::ranges::max_element(candidates, {}, share);
    if (share(*least) <= kExplainsPoses) break;
    candidates.erase(least);
  }
  return candidates;
}

}  // namespace

void set_turn(const LensTurn& turn, CameraComparison& camera) {
  camera.rotated = turn.rotation;
  if (camera.focus) camera.focus->rotated = turn.in_focus;
}

std::optional<Rig> fold_turns(const PoseTask& poses, const std::vector<std::optional<LensTurn>>& turns, RigComparison& result) {
  Cameras candidates;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    CameraComparison& camera = result.cameras[i];
    if (turns[i] && explains_rays(camera, *turns[i])) candidates.push_back({&camera, &*turns[i]});
  }
  const Cameras turned = cancelling(std::move(candidates), poses, result.poses);
  if (turned.empty()) return std::nullopt;
  Rig reference = with_turns(poses.reference, turned);
  const std::vector<PoseComparison> folded = compared_with(reference, poses);
  for (const auto& [camera, turn] : turned) {
    camera->turn_cancels = true;
    set_turn(*turn, *camera);
    for (std::size_t i = 0; i < folded.size(); ++i) {
      if (is_of(folded[i], *camera)) result.poses[i].remaining = PoseDistance{folded[i].angle_rad, folded[i].distance_m};
    }
  }
  return reference;
}

}  // namespace fca::internal
