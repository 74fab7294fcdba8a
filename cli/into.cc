// SPDX-License-Identifier: BSD-3-Clause
#include "into.h"

#include <fca/formats/pose_agreement.h>

#include <algorithm>

namespace fca::cli {

namespace {

/// Names the rig's cameras as the base's of the same place. Any other name of a camera of the base, also of one that was left
/// out of the input and has a pose yet, becomes "NAME of the input".
void take_names(const Rig& base, Rig& rig) {
  std::vector<std::pair<std::string, std::string>> names;
  for (std::size_t i = 0; i < std::min(base.cameras.size(), rig.cameras.size()); ++i)
    names.emplace_back(rig.cameras[i].name, base.cameras[i].name);
  const auto renamed = [&](const std::string& name) -> std::string {
    const auto row = std::ranges::find(names, name, &std::pair<std::string, std::string>::first);
    if (row != names.end()) return row->second;
    return base.find_camera(name) != nullptr ? name + " of the input" : name;
  };
  for (Camera& camera : rig.cameras) camera.name = renamed(camera.name);
  for (PoseEdge& edge : rig.poses) {
    edge.a = renamed(edge.a);
    edge.b = renamed(edge.b);
  }
}

template <class T>
void keep(std::optional<T>& value, const std::optional<T>& otherwise) {
  if (!value) value = otherwise;
}

/// The base's poses beside those that the rig states. They keep their numbers, also where they contradict each other, unless
/// the rig moves something that one of them speaks of, too: then it follows.
void keep_poses(const Rig& base, Rig& rig, Diagnostics& diagnostics) {
  // What the base says of the rig's own edges. Edge for edge the same, so that both resolve along the same path.
  Rig before;
  for (const PoseEdge& edge : rig.poses) {
    const Transform* stated = base.stated(edge.a, edge.b);
    const std::optional<Transform> T = stated != nullptr ? *stated : base.resolve(edge.a, edge.b);
    if (T) before.poses.push_back({edge.a, edge.b, *T});
  }
  for (PoseEdge edge : base.poses) {
    if (rig.stated(edge.a, edge.b) != nullptr) continue;
    const PoseEdge as_it_was = edge;
    const std::optional<Transform> now = rig.resolve(edge.a, edge.b);
    const std::optional<Transform> then = before.resolve(edge.a, edge.b);
    const bool moved = now && !(then && agree(*now, *then)) && !agree(*now, edge.T_a_b);
    if (moved) {
      edge.T_a_b = *now;
      // The same statement the other way round is no second one.
      if (rig.stated(edge.b, edge.a) == nullptr) {
        diagnostics.note("pose-follows", "the base states the pose of " + edge.a + " relative to " + edge.b +
                                             ", which a pose of the input contradicts; it is written as it follows from that");
      }
    }
    rig.poses.push_back(edge);
    before.poses.push_back(as_it_was);
  }
}

}  // namespace

Rig put_into(const Rig& base, Rig rig, Diagnostics& diagnostics) {
  take_names(base, rig);
  for (Camera& camera : rig.cameras) {
    const Camera* before = base.find_camera(camera.name);
    if (before == nullptr) continue;
    keep(camera.image_size, before->image_size);
    keep(camera.time_offset_s, before->time_offset_s);
    keep(camera.frame_rate_hz, before->frame_rate_hz);
    if (camera.topic.empty()) camera.topic = before->topic;
  }
  for (std::size_t i = rig.cameras.size(); i < base.cameras.size(); ++i) {
    diagnostics.note("camera-kept", base.cameras[i].name + " of the base is not in the input and stays as it is");
    rig.cameras.push_back(base.cameras[i]);
  }
  if (rig.imus.empty()) rig.imus = base.imus;
  keep(rig.baseline_m, base.baseline_m);
  keep_poses(base, rig, diagnostics);
  return rig;
}

}  // namespace fca::cli
