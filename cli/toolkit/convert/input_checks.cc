// SPDX-License-Identifier: BSD-3-Clause
#include "input_checks.h"

#include <fca/code.h>

#include <algorithm>

namespace fca {

namespace {

/// Adds the error of an input without cameras. The message suggests to give the file as a second input.
void explain_no_camera(const ConvertRequest& request, const Calibration& calibration, Diagnostics& diagnostics) {
  const Rig& rig = calibration.rig;
  Message content{Code::kNoCameraAtAll};
  if (!rig.imus.empty()) {
    content = {Code::kImuAndNoCamera};
  } else if (!rig.poses.empty()) {
    content = {Code::kPoseAndNoCamera, {rig.poses.size()}};
  }
  const std::string& input = request.inputs.files.front();
  const Message target =
      request.into.empty() ? Message{Code::kAsFormat, {request.to->id}} : Message{Code::kIntoFile, {request.into}};
  diagnostics.add(Code::kNothingToConvert, {content, calibration.format->main_file, input, target}, {input, 0, 0});
}

/// True, with an error, if the request gives a baseline although the input has several cameras, whose poses give it.
bool baseline_contradicts(const ConvertRequest& request, const Calibration& calibration, ConvertResult& result) {
  if (!request.baseline_m || calibration.rig.cameras.size() < 2) return false;
  result.diagnostics.add(Code::kBaselineOfSeveral, {calibration.rig.cameras.size()}, {request.inputs.files.front(), 0, 0});
  result.status = Status::kBadRequest;
  return true;
}

/// True, with an error, if no IMU of the rig has a pose, but the poses contain an IMU of another name.
bool has_pose_of_other_imu(const Rig& rig, const std::string& input, Diagnostics& diagnostics) {
  const auto has_pose = [&rig](const std::string& name) {
    return std::ranges::any_of(rig.poses, [&name](const PoseEdge& edge) { return edge.a == name || edge.b == name; });
  };
  const auto is_imu = [&rig](const std::string& frame) { return rig.kind_of(frame) == FrameKind::kImu; };
  if (rig.imus.empty() || std::ranges::any_of(rig.imus, has_pose, &Imu::name)) return false;
  const auto other = std::ranges::find_if(rig.poses, [&](const PoseEdge& edge) { return is_imu(edge.a) || is_imu(edge.b); });
  if (other == rig.poses.end()) return false;
  const std::string& posed = is_imu(other->a) ? other->a : other->b;
  const std::string& given = rig.imus.front().name;
  diagnostics.add(Code::kImuIsAnother, {posed, given}, {input, 0, 0});
  return true;
}

}  // namespace

bool input_is_convertible(const ConvertRequest& request, const Calibration& input, ConvertResult& result) {
  const bool imu_file = result.to->imu_file && request.into.empty() && !input.rig.imus.empty();
  if (input.rig.cameras.empty() && !imu_file) {
    explain_no_camera(request, input, result.diagnostics);
    return false;
  }
  return !baseline_contradicts(request, input, result) &&
         !has_pose_of_other_imu(input.rig, request.inputs.files.front(), result.diagnostics);
}

}  // namespace fca
