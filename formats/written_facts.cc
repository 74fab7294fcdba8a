// SPDX-License-Identifier: BSD-3-Clause
#include "written_facts.h"

#include <fca/code.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace fca {

bool states_poses(const VerdictFacts& facts) {
  constexpr std::array<std::string_view, 3> kWithout = {"mono", "rgbd", kLensAlone};
  return facts.to->extrinsics && std::ranges::find(kWithout, facts.mode) == kWithout.end();
}

bool is_written(const std::string& camera, const VerdictFacts& facts) {
  return facts.files.empty() || std::ranges::any_of(facts.files, [&camera](const std::vector<std::string>& cameras) {
           return std::ranges::find(cameras, camera) != cameras.end();
         });
}

namespace {

/// Does a written file specify the pose, or can what it specifies be derived from it?
bool is_written(const PoseEdge& edge, const VerdictFacts& facts) {
  if (facts.files.empty()) return true;
  if (!states_poses(facts)) return false;
  const bool uses_imu = facts.to->imu && (facts.to->modes.empty() || facts.mode.ends_with("inertial"));
  const auto frame_is_written = [&](const std::string& frame) {
    switch (facts.rig->kind_of(frame)) {
      case FrameKind::kImu:
        return uses_imu;
      case FrameKind::kVehicle:
        return facts.to->frame == "vehicle";
      case FrameKind::kCamera:
        return is_written(frame, facts);
      case FrameKind::kOther:
        return true;
    }
    return true;
  };
  if (frame_is_written(edge.a) && frame_is_written(edge.b)) return true;
  // Cameras of one file, or a pair of files, that a frame between them relates.
  const auto has_several = [](const std::vector<std::string>& cameras) { return cameras.size() > 1; };
  const bool is_pair_of_files = facts.to->pair_poses && facts.files.size() > 1;
  return (is_pair_of_files || std::ranges::any_of(facts.files, has_several)) && facts.rig->kind_of(edge.a) != FrameKind::kImu &&
         facts.rig->kind_of(edge.b) != FrameKind::kImu;
}

}  // namespace

bool is_of_unwritten_pose(const Finding& finding, const VerdictFacts& facts) {
  if (facts.files.empty() || facts.rig == nullptr) return false;
  const auto is_named = [&finding](const PoseEdge& edge) {
    return !finding.facts.arguments.empty() && finding.facts.arguments.front() == Argument(name_of(edge));
  };
  const auto named = std::ranges::find_if(facts.rig->poses, is_named);
  if (named != facts.rig->poses.end()) return !is_written(*named, facts);
  return info(code_of(finding)).about == About::kPoses && !facts.rig->poses.empty() &&
         std::ranges::none_of(facts.rig->poses, [&facts](const PoseEdge& edge) { return is_written(edge, facts); });
}

Message written_statement(const Contradiction& contradiction, const VerdictFacts& facts) {
  const std::vector<PoseEdge>& poses = facts.rig->poses;
  const PoseEdge& stated = poses[contradiction.loop.edge];
  Rig written;
  written.poses.assign(facts.written_poses.begin(), facts.written_poses.end());
  const auto is_written_as_stated = [&written](const PoseEdge& edge) {
    const std::optional<Transform> T = written.resolve(edge.a, edge.b);
    return T && !difference_of(*T, edge.T_a_b).contradicts();
  };
  std::vector<std::string> others;
  std::vector<std::string> others_as_stated;
  for (const std::size_t other : contradiction.loop.path) {
    others.push_back(name_of(poses[other]));
    if (is_written_as_stated(poses[other])) others_as_stated.push_back(others.back());
  }
  const std::optional<Transform> T = written.resolve(stated.a, stated.b);
  if (!T) return others_as_stated.empty() ? Message{} : Message{Code::kPoseWrittenAsGiven, {others_as_stated}};
  const bool is_as_stated = is_written_as_stated(stated);
  std::erase_if(written.poses, [&stated](const PoseEdge& edge) {
    return (edge.a == stated.a && edge.b == stated.b) || (edge.a == stated.b && edge.b == stated.a);
  });
  const std::optional<Transform> by_others = written.resolve(stated.a, stated.b);
  if (by_others && difference_of(*T, *by_others).contradicts()) return {Code::kPosesWrittenBoth};
  if (is_as_stated) return {Code::kPoseWrittenAsGiven, {std::vector<std::string>{name_of(stated)}}};
  return {Code::kPoseWrittenAsDerived, {name_of(stated), others}};
}

}  // namespace fca
