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

/// Returns, for each camera of the rig, the camera of the base that it replaces. Null: the camera is added. Cameras are matched
/// by index if `in_order` is set or if no camera of the rig has the name of one in the base, otherwise by name.
std::vector<const Camera*> counterparts(const Rig& base, const Rig& rig, bool in_order) {
  const auto is_in_base = [&base](const Camera& camera) { return base.find_camera(camera.name) != nullptr; };
  const bool by_name = !in_order && std::ranges::any_of(rig.cameras, is_in_base);
  std::vector<const Camera*> result;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera* at_index = i < base.cameras.size() ? &base.cameras[i] : nullptr;
    result.push_back(by_name ? base.find_camera(rig.cameras[i].name) : at_index);
  }
  return result;
}

/// Gives the rig's cameras, and the frames of its poses, the names of their counterparts. An added camera keeps its name, or
/// gets an unused one if that name is taken. The input's poses may contain a camera that is not converted. If the base has
/// another camera of that name, the frame of the input's camera becomes "input/NAME".
void take_names(const Rig& base, std::span<const Camera* const> counterparts, Rig& rig, Kept& kept, Diagnostics& diagnostics) {
  std::vector<std::pair<std::string, std::string>> names;  // old name, new name
  const auto is_taken = [&](const std::string& name) {
    return base.find_camera(name) != nullptr ||
           std::ranges::find(names, name, &std::pair<std::string, std::string>::second) != names.end();
  };
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const std::string& name = rig.cameras[i].name;
    if (counterparts[i] == nullptr) {
      std::string unused = name;
      for (std::size_t number = 0; is_taken(unused); ++number) unused = "cam" + std::to_string(number);
      names.emplace_back(name, unused);
      continue;
    }
    names.emplace_back(name, counterparts[i]->name);
    if (name == names.back().second) continue;
    kept.replaced.push_back(names.back().second);
    diagnostics.add(Code::kCameraReplaced, {name, names.back().second});
  }
  const auto new_name_of = [&](const std::string& name) -> std::string {
    const auto row = std::ranges::find(names, name, &std::pair<std::string, std::string>::first);
    if (row != names.end()) return row->second;
    return base.find_camera(name) != nullptr ? "input/" + name : name;
  };
  for (Camera& camera : rig.cameras) {
    camera.name = new_name_of(camera.name);
    kept.names.push_back(camera.name);
  }
  for (PoseEdge& edge : rig.poses) {
    edge.a = new_name_of(edge.a);
    edge.b = new_name_of(edge.b);
  }
}

/// Returns the cameras of the base in their order, each replaced by the camera of the rig with the same name if there is one.
/// Cameras that only the rig has follow. Cameras that only the base has are listed in `kept`.
std::vector<Camera> merged_cameras(const Rig& base, const Rig& rig, Kept& kept) {
  std::vector<Camera> cameras;
  for (const Camera& camera : base.cameras) {
    const Camera* replacement = rig.find_camera(camera.name);
    if (replacement == nullptr) kept.cameras.push_back(camera.name);
    cameras.push_back(replacement != nullptr ? *replacement : camera);
  }
  std::ranges::copy_if(rig.cameras, std::back_inserter(cameras),
                       [&base](const Camera& camera) { return base.find_camera(camera.name) == nullptr; });
  return cameras;
}

template <class T>
void fill_in(std::optional<T>& value, const std::optional<T>& of_base) {
  if (!value) value = of_base;
}

/// Adds the base's poses that the rig does not contain. A pose keeps its value, even if it contradicts other poses, unless the
/// rig's poses give its frames another pose than the base's did. Then the value is computed from the rig, with a note.
void keep_poses(const Rig& base, Rig& rig, Kept& kept, Diagnostics& diagnostics) {
  // `before` has the edges of the rig with the values of the base. Both have the same edges, so that resolve() computes a pose
  // along the same path in both.
  Rig before;
  const Rig input = rig;
  for (const PoseEdge& edge : rig.poses) {
    const Transform* direct = base.stated(edge.a, edge.b);
    const std::optional<Transform> T = direct != nullptr ? *direct : base.resolve(edge.a, edge.b);
    if (T) before.poses.push_back({edge.a, edge.b, *T});
  }
  for (PoseEdge edge : base.poses) {
    if (rig.stated(edge.a, edge.b) != nullptr) continue;
    const PoseEdge of_base = edge;
    const std::optional<Transform> now = rig.resolve(edge.a, edge.b);
    const std::optional<Transform> then = before.resolve(edge.a, edge.b);
    const bool is_moved = now && !(then && agree(*now, *then)) && !agree(*now, edge.T_a_b);
    if (is_moved) {
      edge.T_a_b = *now;
      // If the rig contains the pose in the other direction, the user gave its new value and needs no note.
      if (rig.stated(edge.b, edge.a) == nullptr) diagnostics.add(Code::kPoseFollows, {edge.a, edge.b});
    }
    const auto has_other_model = [&](const std::string& name) {
      const Camera* in_base = base.find_camera(name);
      const Camera* in_rig = rig.find_camera(name);
      return in_base != nullptr && in_rig != nullptr && in_base->model != in_rig->model;
    };
    if (!input.resolve(edge.a, edge.b) && (has_other_model(edge.a) || has_other_model(edge.b))) kept.poses.push_back(edge);
    rig.poses.push_back(edge);
    before.poses.push_back(of_base);
  }
  for (const Frame& frame : base.frames) rig.add_frame(frame.name, frame.kind);
}

/// A base that contains poses but no cameras may number the cameras (cam0, ...). If the rig's cameras have other names, returns
/// the base with the frame of camera number i renamed to the rig's camera i. Otherwise returns the base unchanged.
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

bool has_common_pose(const Rig& base_in_file, const Rig& rig) {
  const Rig base = with_names_of(rig, base_in_file);
  return std::ranges::any_of(base.poses, [&rig](const PoseEdge& edge) { return rig.resolve(edge.a, edge.b).has_value(); });
}

Rig put_into(const Rig& base_in_file, Rig rig, bool in_order, Kept& kept, Diagnostics& diagnostics) {
  const Rig base = with_names_of(rig, base_in_file);
  take_names(base, counterparts(base, rig, in_order), rig, kept, diagnostics);
  for (Camera& camera : rig.cameras) {
    const Camera* before = base.find_camera(camera.name);
    if (before == nullptr) continue;
    fill_in(camera.image_size, before->image_size);
    fill_in(camera.time_offset_s, before->time_offset_s);
    fill_in(camera.frame_rate_hz, before->frame_rate_hz);
    if (camera.topic.empty()) camera.topic = before->topic;
  }
  if (!rig.baseline_m && !rig.cameras.empty() && !base.cameras.empty() &&
      rig.cameras.front().model != base.cameras.front().model)
    kept.baseline_m = base.baseline_m;
  rig.cameras = merged_cameras(base, rig, kept);
  if (rig.imus.empty()) rig.imus = base.imus;
  fill_in(rig.baseline_m, base.baseline_m);
  keep_poses(base, rig, kept, diagnostics);
  return rig;
}

void report_kept(const Kept& kept, const Written& written, Diagnostics& diagnostics) {
  const Written::File& file = written.files.front();
  for (const std::string& camera : kept.cameras) {
    if (std::ranges::find(file.cameras, camera) != file.cameras.end()) diagnostics.add(Code::kCameraKept, {camera});
  }
  const std::optional<Rig>& in_file = file.says;
  if (kept.baseline_m && in_file && in_file->baseline_m) diagnostics.add(Code::kBaselineKept, {100.0 * *kept.baseline_m});
  std::vector<std::string> poses;
  for (const PoseEdge& edge : kept.poses) {
    if (in_file && in_file->resolve(edge.a, edge.b)) poses.push_back(edge.b + " -> " + edge.a);
  }
  if (poses.empty()) return;
  diagnostics.add(poses.size() == 1 ? Code::kPoseKept : Code::kPosesKept, {poses});
}

}  // namespace fca
