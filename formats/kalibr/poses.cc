// SPDX-License-Identifier: BSD-3-Clause
#include "poses.h"

#include "layout.h"

#include <fca/formats/pose_agreement.h>

namespace fca::kalibr {

std::vector<PoseKey> pose_keys(const std::string& camera) {
  std::vector<PoseKey> keys;
  const std::size_t index = index_in(camera, "cam").value_or(0);
  if (index > 0) keys.push_back({"T_cn_cnm1", camera, indexed("cam", index - 1)});
  keys.push_back({"T_cam_imu", camera, "imu0"});
  keys.push_back({"T_imu_cam", "imu0", camera});
  return keys;
}

std::optional<PoseKey> named_pose_key(const std::string& key) {
  constexpr std::string_view kPrefix = "T_";
  if (!key.starts_with(kPrefix)) return std::nullopt;
  const std::size_t split = key.find('_', kPrefix.size());
  if (split == std::string::npos) return std::nullopt;
  PoseKey pose = {key, key.substr(kPrefix.size(), split - kPrefix.size()), key.substr(split + 1)};
  if (!index_in(pose.a, "cam") || !index_in(pose.b, "cam")) return std::nullopt;
  return pose;
}

void add_pose(const PoseKey& pose, const Transform& T, Rig& rig) {
  rig.poses.push_back({pose.a, pose.b, T});
  for (const std::string& frame : {pose.a, pose.b}) {
    if (index_in(frame, "imu")) rig.add_frame(frame, FrameKind::kImu);
  }
}

std::optional<Transform> pose_in(const Rig& rig, std::string_view a, std::string_view b) {
  const Transform* stated = rig.stated(a, b);
  return stated != nullptr ? *stated : rig.resolve(a, b);
}

bool lacks_pose(const Rig& said, const Rig& rig, std::string_view a, std::string_view b) {
  const std::optional<Transform> T = pose_in(rig, a, b);
  if (!T) return false;
  const std::optional<Transform> there = said.resolve(a, b);
  if (!there) return true;
  const bool states_it = rig.stated(a, b) != nullptr || rig.stated(b, a) != nullptr;
  return states_it && !agree(*there, *T);
}

}  // namespace fca::kalibr
