// SPDX-License-Identifier: BSD-3-Clause
// Two cameras of which a file says that they are a stereo pair.
#include "stereo.h"

#include <fca/code.h>
#include <fca/rectify/rectify.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::checks {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

struct ClaimedPair {
  std::string first;
  std::string second;
  Transform T_second_first;
};

/// Two cameras for ORB-SLAM3, OpenCV's R and T, or a rectified pair.
std::optional<ClaimedPair> claimed_pair(const Subject& subject) {
  const Rig& rig = subject.rig();
  const bool is_stereo_file = subject.is("orbslam3") || (subject.is("opencv") && rig.stated("cam1", "cam0") != nullptr);
  ClaimedPair pair;
  if (rig.rectified && rig.rectified->sources.empty()) {
    pair = {rig.rectified->views[0].camera, rig.rectified->views[1].camera, {}};
  } else if (rig.cameras.size() == 2 && is_stereo_file) {
    pair = {rig.cameras[0].name, rig.cameras[1].name, {}};
  } else {
    return std::nullopt;
  }
  const std::optional<Transform> T = rig.resolve(pair.second, pair.first);
  const std::optional<Transform> exact = T && rotation_determinant(*T) > 0.0 ? nearest_rotation(*T) : std::nullopt;
  if (!exact) return std::nullopt;
  pair.T_second_first = *exact;
  for (int row = 0; row < 3; ++row) pair.T_second_first(row, 3) = (*T)(row, 3);
  return pair;
}

/// About the axis and of the axis, as one rotation after the other (swing and twist).
void check_turn(const ClaimedPair& pair, const FindPlace& where, Findings& findings) {
  constexpr double kTurned = 60.0;  // deg
  const Quaternion q = quaternion_of(pair.T_second_first);
  const double roll = std::abs(2.0 * std::atan2(q[2], q[3])) * kDegrees;
  const double turn = std::acos(std::clamp(pair.T_second_first(2, 2), -1.0, 1.0)) * kDegrees;
  if (turn > kTurned) {
    findings.add(Code::kPairTurned, {pair.first, pair.second, turn}, where());
  } else if (roll > kTurned) {
    findings.add(Code::kPairRolled, {pair.first, pair.second, roll}, where());
  }
}

/// Does the rectification specify the same pose?
void check_rectification(const Subject& subject, const ClaimedPair& pair, const FindPlace& where, Findings& findings) {
  const std::optional<RectifiedPair>& rectified = subject.rig().rectified;
  if (!rectified || !rectified->sources.empty()) return;
  const Transform stated = pose_of(*rectified);
  const double angle = angle_between(stated, pair.T_second_first) * kDegrees;
  const double metres = distance_between(stated, pair.T_second_first);
  constexpr double kLargestAngle = 0.5;  // deg
  const double largest_distance = 0.05 * distance_of(pair.T_second_first);
  constexpr double kNoticeable = 0.1;  // of these
  if (angle <= kNoticeable * kLargestAngle && metres <= kNoticeable * largest_distance) return;
  constexpr double kMmPerM = 1000.0;
  findings.add(angle > kLargestAngle || metres > largest_distance ? Severity::kError : Severity::kWarning,
               Code::kRectificationContradicts, {pair.first, pair.second, angle, kMmPerM * metres}, where());
}

}  // namespace

void check_stereo_pair(const Subject& subject, const FindPlace& where, Findings& findings) {
  const std::optional<ClaimedPair> pair = claimed_pair(subject);
  if (!pair) return;
  check_turn(*pair, where, findings);
  check_rectification(subject, *pair, where, findings);
  constexpr double kFarApart = 2.0;  // m
  constexpr double kNoRig = 10.0;    // m; more is a wrong unit, which has a finding of its own
  const double metres = distance_of(pair->T_second_first);
  if (metres > kFarApart && metres <= kNoRig && !findings.has(Code::kAnyTranslationInMm, where()))
    findings.add(Code::kPairFarApart, {pair->first, pair->second, metres}, where());
}

}  // namespace fca::checks
