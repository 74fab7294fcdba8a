// SPDX-License-Identifier: BSD-3-Clause
#include "input_checks.h"

#include "words.h"

#include <algorithm>

namespace fca {

namespace {

/// A file without a camera was probably meant as a further part.
void explain_no_camera(const ConvertRequest& request, const Calibration& calibration, Diagnostics& diagnostics) {
  const bool imu = !calibration.rig.imus.empty();
  const std::string what = imu ? "an IMU and no camera" : calibration.rig.poses.empty() ? "no camera" : "a pose and no camera";
  const std::string main_file = calibration.format->id == "opencv" ? "intrinsics.yml" : "camchain.yaml";
  const std::string& input = request.inputs.files.front();
  const std::string target = request.into.empty() ? " --to " + std::string(request.to->id) : " --into " + request.into;
  diagnostics.error("no-camera", "the file holds " + what, {input, 0, 0},
                    "did you mean: fca-io convert " + shell_word(main_file) + " --with " + shell_word(input) + target);
}

bool contradicts(const ConvertRequest& request, const Calibration& calibration, ConvertResult& result) {
  if (!request.baseline_m || calibration.rig.cameras.size() < 2) return false;
  result.diagnostics.error("baseline-contradicts",
                           "--baseline is for one camera of a rectified pair or depth sensor; here are " +
                               std::to_string(calibration.rig.cameras.size()) + " cameras with poses of their own",
                           {request.inputs.files.front(), 0, 0}, "choose one with --camera");
  result.status = Status::kBadRequest;
  return true;
}

/// The file of one IMU and the poses of another: where that one stands nobody said.
bool imu_is_another(const Rig& rig, const std::string& input, Diagnostics& diagnostics) {
  const auto is_posed = [&rig](const std::string& name) {
    return std::ranges::any_of(rig.poses, [&name](const PoseEdge& edge) { return edge.a == name || edge.b == name; });
  };
  const auto is_imu = [&rig](const std::string& frame) { return rig.kind_of(frame) == FrameKind::kImu; };
  if (rig.imus.empty() || std::ranges::any_of(rig.imus, is_posed, &Imu::name)) return false;
  const auto other = std::ranges::find_if(rig.poses, [&](const PoseEdge& edge) { return is_imu(edge.a) || is_imu(edge.b); });
  if (other == rig.poses.end()) return false;
  const std::string& posed = is_imu(other->a) ? other->a : other->b;
  const std::string& given = rig.imus.front().name;
  diagnostics.error("imu-without-pose", "the cameras' poses are to " + posed + ", and the IMU that is given is " + given,
                    {input, 0, 0}, "give the file of " + posed + "'s noise, or rename " + given + " if it is that one");
  return true;
}

}  // namespace

bool serves(const ConvertRequest& request, const Calibration& input, ConvertResult& result) {
  const bool imu_file = result.to->imu_file && request.into.empty() && !input.rig.imus.empty();
  if (input.rig.cameras.empty() && !imu_file) {
    explain_no_camera(request, input, result.diagnostics);
    return false;
  }
  return !contradicts(request, input, result) && !imu_is_another(input.rig, request.inputs.files.front(), result.diagnostics);
}

}  // namespace fca
