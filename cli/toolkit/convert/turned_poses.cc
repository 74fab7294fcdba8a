// SPDX-License-Identifier: BSD-3-Clause
#include "turned_poses.h"

#include <fca/code.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <string>

namespace fca {

void turn_poses(const std::vector<ConvertedCamera>& cameras, Rig& rig) {
  for (const ConvertedCamera& camera : cameras) {
    if (!camera.report || !camera.report->turn) continue;
    const Transform& T_target_source = camera.report->turn->T_target_source;
    const Transform T_source_target = inverse(T_target_source).value();
    for (PoseEdge& edge : rig.poses) {
      if (edge.a == camera.target.name) edge.T_a_b = T_target_source * edge.T_a_b;
      if (edge.b == camera.target.name) edge.T_a_b = edge.T_a_b * T_source_target;
    }
    if (!rig.rectified) continue;
    for (RectifiedPair::View& view : rig.rectified->views) {
      if (view.camera == camera.target.name) view.T_rectified_camera = view.T_rectified_camera * T_source_target;
    }
  }
}

void report_turns(const std::vector<PoseEdge>& written, std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics) {
  for (ConvertedCamera& camera : cameras) {
    if (!camera.report) continue;
    const std::string& name = camera.target.name;
    const bool has_pose =
        std::ranges::any_of(written, [&name](const PoseEdge& edge) { return edge.a == name || edge.b == name; });
    const double rms_px = camera.report->statistics.error.rms;
    if (const std::optional<AbsorbedTurn>& turn = camera.report->turn) {
      const auto [x, y, z] = rotation_vector(turn->T_target_source);
      if (has_pose) {
        diagnostics.add(Code::kTurnedIntoPose, {name, turn->angle_deg, rms_px, turn->rms_before_px});
      } else {
        diagnostics.add(Code::kTurnHasNoPose, {name, turn->angle_deg, x, y, z});
      }
    }
    if (!has_pose) camera.report->turn_offer.reset();
    if (const std::optional<TurnOffer>& offer = camera.report->turn_offer)
      diagnostics.add(Code::kTurnWouldHelp, {name, offer->angle_deg, offer->rms_px, rms_px});
  }
}

}  // namespace fca
