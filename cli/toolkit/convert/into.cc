// SPDX-License-Identifier: BSD-3-Clause
#include "into.h"

#include <fca/code.h>
#include <fca/formats/pose_agreement.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

namespace fca {

namespace {

/// For each camera of the rig, the camera of the base that it replaces; null: it is added. Cameras are matched by name if any
/// of the rig's names is in the base and the request gives no order, otherwise by index.
std::vector<const Camera*> counterparts(const Rig& base, const Rig& rig, bool in_order) {
  const auto known = [&base](const Camera& camera) { return base.find_camera(camera.name) != nullptr; };
  const bool by_name = !in_order && std::ranges::any_of(rig.cameras, known);
  std::vector<const Camera*> result;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera* in_place = i < base.cameras.size() ? &base.cameras[i] : nullptr;
    result.push_back(by_name ? base.find_camera(rig.cameras[i].name) : in_place);
  }
  return result;
}

/// Gives the rig's cameras the names of their counterparts. An added camera keeps its name, or gets an unused one if the name
/// is taken. Poses of the input may name a camera that was removed from it and that the base also has; its name becomes
/// "input/NAME".
void take_names(const Rig& base, std::span<const Camera* const> counterparts, Rig& rig, Kept& kept, Diagnostics& diagnostics) {
  std::vector<std::pair<std::string, std::string>> names;
  const auto is_taken = [&](const std::string& name) {
    return base.find_camera(name) != nullptr ||
           std::ranges::find(names, name, &std::pair<std::string, std::string>::second) != names.end();
  };
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const std::string& name = rig.cameras[i].name;
    if (counterparts[i] == nullptr) {
      std::string added = name;
      for (std::size_t place = 0; is_taken(added); ++place) added = "cam" + std::to_string(place);
      names.emplace_back(name, added);
      continue;
    }
    names.emplace_back(name, counterparts[i]->name);
    if (name == names.back().second) continue;
    kept.replaced.push_back(names.back().second);
    diagnostics.add(Code::kCameraReplaced, {name, names.back().second});
  }
  const auto renamed = [&](const std::string& name) -> std::string {
    const auto row = std::ranges::find(names, name, &std::pair<std::string, std::string>::first);
    if (row != names.end()) return row->second;
    return base.find_camera(name) != nullptr ? "input/" + name : name;
  };
  for (Camera& camera : rig.cameras) {
    camera.name = renamed(camera.name);
    kept.names.push_back(camera.name);
  }
  for (PoseEdge& edge : rig.poses) {
    edge.a = renamed(edge.a);
    edge.b = renamed(edge.b);
  }
}

/// The cameras of the base in their order, replaced by those of the rig with the same names, then those that only the rig has.
std::vector<Camera> merged_cameras(const Rig& base, const Rig& rig, Kept& kept) {
  std::vector<Camera> cameras;
  for (const Camera& camera : base.cameras) {
    const Camera* now = rig.find_camera(camera.name);
    if (now == nullptr) kept.cameras.push_back(camera.name);
    cameras.push_back(now != nullptr ? *now : camera);
  }
  std::ranges::copy_if(rig.cameras, std::back_inserter(cameras),
                       [&base](const Camera& camera) { return base.find_camera(camera.name) == nullptr; });
  return cameras;
}

template <class T>
void keep(std::optional<T>& value, const std::optional<T>& otherwise) {
  if (!value) value = otherwise;
}

/// Adds the base's poses that the rig does not have. They keep their values, even if they contradict each other, unless the rig
/// moves a frame of such a pose: then the pose is computed from the rig.
void keep_poses(const Rig& base, Rig& rig, Kept& kept, Diagnostics& diagnostics) {
  // The rig's edges with the base's values. The edges are the same, so that both resolve along the same path.
  Rig before;
  const Rig input = rig;
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
      // The same pose in the other direction needs no note.
      if (rig.stated(edge.b, edge.a) == nullptr) diagnostics.add(Code::kPoseFollows, {edge.a, edge.b});
    }
    const auto is_another = [&](const std::string& name) {
      const Camera* then_there = base.find_camera(name);
      const Camera* now_there = rig.find_camera(name);
      return then_there != nullptr && now_there != nullptr && then_there->model != now_there->model;
    };
    if (!input.resolve(edge.a, edge.b) && (is_another(edge.a) || is_another(edge.b))) kept.poses.push_back(edge);
    rig.poses.push_back(edge);
    before.poses.push_back(as_it_was);
  }
  for (const Frame& frame : base.frames) rig.add_frame(frame.name, frame.kind);
}

/// A base that contains only poses may number its cameras (cam0, ...). If the rig's cameras have other names, the numbers are
/// replaced by the rig's names in order.
Rig with_names_of(const Rig& rig, Rig base) {
  if (!base.cameras.empty() || rig.cameras.size() < 2) return base;
  const auto frames = [&base] {
    std::vector<std::string*> all;
    for (PoseEdge& edge : base.poses) all.insert(all.end(), {&edge.a, &edge.b});
    return all;
  }();
  if (std::ranges::all_of(frames, [&rig](const std::string* frame) { return rig.find_camera(*frame) != nullptr; })) return base;
  for (std::string* frame : frames) {
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      if (*frame != "cam" + std::to_string(i)) continue;
      *frame = rig.cameras[i].name;
      break;
    }
  }
  return base;
}

}  // namespace

bool has_common_pose(const Rig& base_as_named, const Rig& rig) {
  const Rig base = with_names_of(rig, base_as_named);
  return std::ranges::any_of(base.poses, [&rig](const PoseEdge& edge) { return rig.resolve(edge.a, edge.b).has_value(); });
}

Rig put_into(const Rig& base_as_named, Rig rig, bool in_order, Kept& kept, Diagnostics& diagnostics) {
  const Rig base = with_names_of(rig, base_as_named);
  take_names(base, counterparts(base, rig, in_order), rig, kept, diagnostics);
  for (Camera& camera : rig.cameras) {
    const Camera* before = base.find_camera(camera.name);
    if (before == nullptr) continue;
    keep(camera.image_size, before->image_size);
    keep(camera.time_offset_s, before->time_offset_s);
    keep(camera.frame_rate_hz, before->frame_rate_hz);
    if (camera.topic.empty()) camera.topic = before->topic;
  }
  if (!rig.baseline_m && !rig.cameras.empty() && !base.cameras.empty() &&
      rig.cameras.front().model != base.cameras.front().model)
    kept.baseline_m = base.baseline_m;
  rig.cameras = merged_cameras(base, rig, kept);
  if (rig.imus.empty()) rig.imus = base.imus;
  keep(rig.baseline_m, base.baseline_m);
  keep_poses(base, rig, kept, diagnostics);
  return rig;
}

void report_kept(const Kept& kept, const Written& written, Diagnostics& diagnostics) {
  const Written::File& file = written.files.front();
  for (const std::string& camera : kept.cameras) {
    if (std::ranges::find(file.cameras, camera) != file.cameras.end()) diagnostics.add(Code::kCameraKept, {camera});
  }
  const std::optional<Rig>& now = file.says;
  if (kept.baseline_m && now && now->baseline_m) diagnostics.add(Code::kBaselineKept, {100.0 * *kept.baseline_m});
  std::vector<std::string> poses;
  for (const PoseEdge& edge : kept.poses) {
    if (now && now->resolve(edge.a, edge.b)) poses.push_back(edge.b + " -> " + edge.a);
  }
  if (poses.empty()) return;
  diagnostics.add(poses.size() == 1 ? Code::kPoseKept : Code::kPosesKept, {poses});
}

}  // namespace fca
