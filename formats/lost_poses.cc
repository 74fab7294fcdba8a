// SPDX-License-Identifier: BSD-3-Clause
#include "lost_poses.h"

#include <fca/code.h>
#include <fca/formats/consumers/consumer.h>
#include <fca/formats/counted_cameras.h>
#include <fca/rig/remove_frame.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace fca {

namespace {

/// To a millimetre and a twentieth of a degree: files specify one pose in several ways, and round it.
bool same_pose(const std::optional<Transform>& a, const std::optional<Transform>& b) {
  constexpr double kTolerance = 1e-3;
  return a && b && std::ranges::equal(a->values, b->values, [](double x, double y) {
           return std::abs(x - y) <= kTolerance * std::max(1.0, std::abs(x));
         });
}

bool is_device(const Rig& rig, const std::string& frame) {
  const FrameKind kind = rig.kind_of(frame);
  return kind == FrameKind::kCamera || kind == FrameKind::kImu;
}

/// The pose as it follows from the others.
std::optional<Transform> around(const Rig& rig, const PoseEdge& edge) {
  Rig others;
  std::ranges::copy_if(rig.poses, std::back_inserter(others.poses), [&edge](const PoseEdge& other) { return &other != &edge; });
  return others.resolve(edge.a, edge.b);
}

/// Frames whose poses to each other are kept.
using Group = std::set<std::string>;

Group group_of(const std::string& frame, const std::set<std::string>& frames, const Rig& rig, const Rig& kept) {
  Group group;
  std::ranges::copy_if(frames, std::inserter(group, group.end()), [&](const std::string& other) {
    return other == frame || same_pose(kept.resolve(frame, other), rig.resolve(frame, other));
  });
  return group;
}

/// Who is to read what is written: DSO's files are TUM-VI's, too.
std::string program_of(const Format& format, const Written& written) {
  for (const Written::File& file : written.files) {
    const consumers::Consumer* consumer = file.programs.empty() ? nullptr : consumers::find_consumer(file.programs.front());
    if (consumer != nullptr && consumer->cameras) return std::string(consumer->program);
  }
  return std::string(format.program);
}

constexpr std::string_view kOfCameras = "T_cam_cam";  // weighs most
constexpr std::string_view kOfImu = "T_cam_imu";

/// What pose it is: one of the two; nothing of other frames.
std::string_view kind_of(const Rig& rig, const PoseEdge& edge) {
  const FrameKind a = rig.kind_of(edge.a);
  const FrameKind b = rig.kind_of(edge.b);
  if (a == FrameKind::kCamera && b == FrameKind::kCamera) return kOfCameras;
  const bool with_camera = a == FrameKind::kCamera || b == FrameKind::kCamera;
  return with_camera && (a == FrameKind::kImu || b == FrameKind::kImu) ? kOfImu : "";
}

/// A camera's pose in an IMU, by which alone it stands somewhere to another camera: then the file loses that, too.
bool places_cameras(const Rig& rig, const Rig& kept, const PoseEdge& edge) {
  const std::string& camera = rig.find_camera(edge.a) != nullptr ? edge.a : edge.b;
  return std::ranges::any_of(rig.cameras, [&](const Camera& other) {
    const std::optional<Transform> T = rig.resolve(camera, other.name);
    return other.name != camera && T && !same_pose(kept.resolve(camera, other.name), T);
  });
}

Loss loss_of(std::string key, const std::vector<std::string>& poses, const Group& a, const Group& b, const std::string& program,
             const Message& remedy) {
  std::vector<Message> groups;
  for (const Group* group : {&a, &b}) {
    if (group->size() > 1) groups.push_back({Code::kPosesOfGroup, {std::vector<std::string>(group->begin(), group->end())}});
  }
  std::vector<Message> kept;
  if (!groups.empty() && a != b) kept.push_back({Code::kPosesOfGroupsKept, {groups}});
  return lost(Code::kPoseDropped, "", std::move(key),
              {poses, program, kept, remedy.is_said() ? remedy : Message{Code::kKeepTheInput}});
}

}  // namespace

std::vector<PoseEdge> poses_in(const Format& format, const Written& written) {
  std::vector<PoseEdge> poses;
  std::map<std::string, std::string> names;  // formats may rename cameras; a file of poses has the names of that of cameras
  Rig cameras;                               // of that one
  for (const Written::File& file : written.files) {
    std::optional<Rig> part = file.says;
    if (!part) continue;
    if (!file.cameras.empty()) {
      names.clear();
      cameras = *part;
    } else if (format.facts_apart) {
      names = counted_cameras(written);
    } else if (format.complete != nullptr && part->cameras.empty()) {
      part->cameras = cameras.cameras;
      part->extra_fields.insert(part->extra_fields.end(), cameras.extra_fields.begin(), cameras.extra_fields.end());
      format.complete(*part);
    }
    for (std::size_t i = 0; i < std::min(part->cameras.size(), file.cameras.size()); ++i)
      names.emplace(part->cameras[i].name, file.cameras[i]);
    const auto name_in_rig = [&names](const std::string& name) { return names.contains(name) ? names.at(name) : name; };
    for (const PoseEdge& edge : part->poses) poses.push_back({name_in_rig(edge.a), name_in_rig(edge.b), edge.T_a_b});
  }
  return poses;
}

std::vector<Loss> lost_poses(const Format& format, const Rig& rig_read, const Written& written) {
  Rig rig = rig_read;
  for (const Camera& camera : rig_read.cameras) {
    // A camera that no file holds is a loss of its own.
    const bool held = std::ranges::any_of(written.files, [&camera](const Written::File& file) {
      return std::ranges::find(file.cameras, camera.name) != file.cameras.end();
    });
    if (!held) remove_frame(camera.name, rig);
  }
  if (rig.poses.empty()) return {};
  Rig kept;
  kept.poses = written.poses;
  std::set<std::string> frames;
  for (const PoseEdge& edge : rig.poses) {
    frames.insert({edge.a, edge.b});
    const bool another_name = edge.T_a_b == Transform{} && !(is_device(rig, edge.a) && is_device(rig, edge.b));
    if (another_name) kept.poses.push_back(edge);
  }
  // In the order in which the poses are specified.
  struct Row {
    std::pair<Group, Group> groups;
    std::string key;
    std::vector<std::string> poses;
  };
  std::vector<Row> lost;
  for (const PoseEdge& edge : rig.poses) {
    const std::optional<Transform> written_pose = kept.resolve(edge.a, edge.b);
    // Of poses that contradict each other a file may keep either.
    if (same_pose(written_pose, edge.T_a_b) || same_pose(written_pose, around(rig, edge))) continue;
    std::pair<Group, Group> groups = {group_of(edge.a, frames, rig, kept), group_of(edge.b, frames, rig, kept)};
    if (groups.second < groups.first) std::swap(groups.first, groups.second);
    std::string_view kind = kind_of(rig, edge);
    if (kind == kOfImu && places_cameras(rig, kept, edge)) kind = kOfCameras;
    // Frames that keep nobody's pose are all alike, if the loss weighs the same.
    const auto is_alone = [](const std::pair<Group, Group>& pair) { return pair.first.size() < 2 && pair.second.size() < 2; };
    auto row = std::ranges::find_if(lost, [&](const Row& each) {
      return each.groups == groups || (is_alone(each.groups) && is_alone(groups) && each.key == kind);
    });
    if (row == lost.end()) row = lost.insert(lost.end(), {groups, {}, {}});
    row->poses.push_back(name_of(edge));
    if (kind == kOfCameras || row->key.empty()) row->key = kind;
  }
  std::vector<Loss> losses;
  losses.reserve(lost.size());
  for (const Row& row : lost) {
    losses.push_back(
        loss_of(row.key, row.poses, row.groups.first, row.groups.second, program_of(format, written), written.pose_remedy));
  }
  return losses;
}

}  // namespace fca
