// SPDX-License-Identifier: BSD-3-Clause
#include "pose_comparison.h"

#include <fca/code.h>
#include <fca/rig/pose_mistake.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::internal {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// Two honest calibrations of one rig are about 1 apart, and common mistakes hundreds.
constexpr double kSameAngle = 0.5 * kRadiansPerDegree;
constexpr double kSameDistance = 5e-3;  // m
constexpr double kSameShare = 0.05;     // of the length
constexpr double kFar = 3.0;
constexpr double kNear = 1.0;
constexpr double kExplainedShare = 0.2;
constexpr double kClose = 0.1;
constexpr double kExact = 1e-3;  // what printed digits leave

/// How far apart two statements of a pose are, in units of what two honest calibrations may differ by.
double distance_of_poses(const Transform& reference, const Transform& other) {
  const double allowed = std::max(kSameDistance, kSameShare * distance_of(reference));
  return std::max(angle_between(reference, other) / kSameAngle, distance_between(reference, other) / allowed);
}

PoseComparison comparison_of(const std::string& a, const std::string& b, const Transform& reference, const Transform& other) {
  PoseComparison result{a, b, 0.0, distance_between(reference, other), distance_of(reference), distance_of(other), {}};
  // What is only roughly a rotation has no angle.
  const std::optional<Transform> right = nearest_rotation(reference);
  const std::optional<Transform> left = nearest_rotation(other);
  result.angle_rad = reference == other ? 0.0 : angle_between(right.value_or(reference), left.value_or(other));
  return result;
}

/// Adds the frames of the poses that are no cameras of the reference, in the order in which they come.
void add_further_frames(const Rig& reference, const std::vector<PoseEdge>& poses, std::vector<std::string>& frames) {
  for (const PoseEdge& edge : poses) {
    for (const std::string& name : {edge.a, edge.b}) {
      const bool unmatched = name.starts_with('\n');
      if (!unmatched && reference.find_camera(name) == nullptr && std::ranges::find(frames, name) == frames.end())
        frames.push_back(name);
    }
  }
}

std::string exchanged(const std::string& name, const std::string& first, const std::string& second) {
  if (name == first) return second;
  return name == second ? first : name;
}

}  // namespace

PoseTask::PoseTask(const Rig& the_reference, const Rig& the_other, const Matching& the_matching)
    : reference(the_reference),
      other(the_other),
      matching(the_matching),
      poses(renamed_poses(the_reference, the_other, the_matching)) {}

void compare_poses(const PoseTask& task, RigComparison& result) {
  Rig other;
  other.poses = task.poses;
  const auto compare = [&](const std::string& a, const std::string& b, const Message& what) {
    const std::optional<Transform> right = task.reference.resolve(a, b);
    const std::optional<Transform> left = other.resolve(a, b);
    if (right && left) result.poses.push_back(comparison_of(a, b, *right, *left));
    if (right.has_value() == left.has_value()) return;
    std::vector<Message>& only = right ? result.only_in_reference : result.only_in_other;
    if (std::ranges::find(only, what) == only.end()) only.push_back(what);
  };
  const auto name_of = [&task](const Match& match) { return task.reference.cameras[match.reference].name; };
  std::vector<std::string> frames;
  add_further_frames(task.reference, task.reference.poses, frames);
  add_further_frames(task.reference, task.poses, frames);
  for (const std::string& frame : frames) {
    for (const Match& match : task.matching.cameras) compare(name_of(match), frame, {Code::kOnlyPose, {frame}});
  }
  if (task.reference.cameras.empty()) {  // files of poses alone: stereo_calib's extrinsics.yml
    for (const PoseEdge& edge : task.reference.poses) compare(edge.a, edge.b, {Code::kOnlyPoseBetween, {edge.a, edge.b}});
  }
  for (std::size_t i = 1; i < task.matching.cameras.size(); ++i) {
    const std::string a = name_of(task.matching.cameras[i]);
    const std::string b = name_of(task.matching.cameras[i - 1]);
    compare(a, b, {Code::kOnlyPoseBetween, {a, b}});
  }
}

bool exchange_explains_poses(const PoseTask& task, std::size_t first, std::size_t second) {
  const std::string one = task.reference.cameras[task.matching.cameras[first].reference].name;
  const std::string two = task.reference.cameras[task.matching.cameras[second].reference].name;
  double as_stated = 0.0;
  double as_exchanged = 0.0;
  for (const PoseEdge& edge : task.poses) {
    const std::optional<Transform> stated = task.reference.resolve(edge.a, edge.b);
    const std::optional<Transform> swapped = task.reference.resolve(exchanged(edge.a, one, two), exchanged(edge.b, one, two));
    if (!stated || !swapped) continue;
    as_stated = std::max(as_stated, distance_of_poses(*stated, edge.T_a_b));
    as_exchanged = std::max(as_exchanged, distance_of_poses(*swapped, edge.T_a_b));
  }
  return as_stated > kFar && as_exchanged < std::min(kNear, kExplainedShare * as_stated);
}

std::size_t comparable_poses(const PoseTask& task) {
  return static_cast<std::size_t>(std::ranges::count_if(
      task.poses, [&task](const PoseEdge& edge) { return task.reference.resolve(edge.a, edge.b).has_value(); }));
}

std::vector<Mistake> mistaken_poses(const PoseTask& task) {
  std::vector<Mistake> mistakes;
  for (std::size_t i = 0; i < task.poses.size(); ++i) {
    const Transform& stated = task.poses[i].T_a_b;
    const std::optional<Transform> right = task.reference.resolve(task.poses[i].a, task.poses[i].b);
    if (!right) continue;
    const double apart = distance_of_poses(*right, stated);
    if (!(apart > kClose)) continue;
    const PoseEdge& own = task.other.poses[i];  // in its own names
    // As near as two honest calibrations are, a mistake is one only if without it nothing differs.
    double best = apart > kFar ? std::min(kNear, kExplainedShare * apart) : kExact;
    const std::string name = name_of(own);
    std::optional<Mistake> mistake;
    for (const PoseMistake& candidate : pose_mistakes()) {
      const std::optional<Transform> undone = candidate.undo(stated);
      const double rest = undone ? distance_of_poses(*right, *undone) : best;
      if (!(rest < best)) continue;
      best = rest;
      mistake = {{candidate.code, {name}}, i};
      if (candidate.code == Code::kPoseHoldsInverse)
        mistake->message = {Code::kPoseInverted, {name, "T_" + own.b + "_" + own.a}};
    }
    // Of a pair whose poses are all exchanged the exchange is told (exchange_explains_poses()); here a copied block.
    const PoseEdge& edge = task.poses[i];
    const bool of_first = task.reference.find_camera(edge.a) != nullptr;
    for (const Camera& camera : task.reference.cameras) {
      if (camera.name == edge.a || camera.name == edge.b) continue;
      const std::optional<Transform> of_it =
          of_first ? task.reference.resolve(camera.name, edge.b) : task.reference.resolve(edge.a, camera.name);
      const double rest = of_it ? distance_of_poses(*of_it, stated) : best;
      if (!(rest < best)) continue;
      best = rest;
      mistake = {{Code::kPoseOfAnotherCamera, {name, camera.name}}, i};
    }
    if (mistake) mistakes.push_back(*std::move(mistake));
  }
  return mistakes;
}

}  // namespace fca::internal

namespace fca {

double PoseComparison::apart() const {
  const double allowed = std::max(internal::kSameDistance, internal::kSameShare * reference_length_m);
  const PoseDistance distance = decisive();
  return std::max(distance.angle_rad / internal::kSameAngle, distance.distance_m / allowed);
}

}  // namespace fca
