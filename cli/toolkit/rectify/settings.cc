// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include "convert/provenance.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>

namespace fca {

namespace {

constexpr std::string_view kOrbSlam2 = "orbslam2";

/// The name of the program for which the settings are.
std::string_view program_of(const RectifyRequest& request) {
  return name_of(request.layout) == kOrbSlam2 ? "ORB-SLAM2" : request.to->program;
}

/// Adds the noise of the IMU and the pose of the rectified left camera in the frame of the IMU, if they are known.
void add_imu(const Rig& input, const Camera& camera, const Transform& T_rectified_camera, Rig& rig) {
  const std::string imu = input.imus.empty() ? "imu0" : input.imus.front().name;
  const std::optional<Transform> T_imu_camera = input.resolve(imu, camera.name);
  const std::optional<Transform> T_camera_rectified = inverse(T_rectified_camera);
  if (T_imu_camera && T_camera_rectified)
    rig.poses.push_back({"imu0", rig.cameras.front().name, *T_imu_camera * *T_camera_rectified});
  if (input.imus.empty()) return;
  rig.imus = {input.imus.front()};
  rig.imus.front().name = "imu0";
}

/// The rig for a format that stores one camera for both rectified images, and the baseline.
Rig rig_of_images(const Rig& input, const RectifyResult& result) {
  Rig rig;
  Camera camera = rectified_camera(result.pair, 0, result.size);
  camera.name = "cam0";
  camera.frame_rate_hz = result.cameras[0].frame_rate_hz;
  camera.time_offset_s = result.cameras[0].time_offset_s;
  camera.topic = result.cameras[0].topic;
  rig.cameras = {std::move(camera)};
  rig.baseline_m = result.pair.offset_m;
  add_imu(input, result.cameras[0], result.pair.views[0].T_rectified_camera, rig);
  rig.rectified = result.pair;
  rig.rectified->size = result.size;
  rig.rectified->sources = {result.cameras[0], result.cameras[1]};
  return rig;
}

/// The rig for a format that stores both original cameras and their rectification.
Rig rig_of_cameras(const RectifyResult& result) {
  Rig rig;
  rig.cameras = {result.cameras[0], result.cameras[1]};
  rig.rectified = result.pair;
  rig.rectified->sources.clear();
  for (std::size_t i = 0; i < 2; ++i) rig.rectified->views.at(i).camera = result.cameras.at(i).name;
  rig.poses = {{result.cameras[1].name, result.cameras[0].name, result.T_second_first}};
  // If pose and rectification contradict each other, the pose is computed from the rectification, since that determines the
  // rectified images.
  if (!states_rectification(rig)) rig.poses.front().T_a_b = pose_of(result.pair);
  return rig;
}

/// True if the format can store this pair. If not, adds an error.
bool can_store(const RectifyRequest& request, const RectifyResult& result, Diagnostics& diagnostics) {
  const auto& [first, second] = result.cameras;
  const auto refuse = [&diagnostics](Code code, std::vector<Argument> facts) {
    diagnostics.add(code, std::move(facts));
    return false;
  };
  const std::string program(program_of(request));
  if (request.to->rectified == RectifiedFiles::kImages) {
    if (result.pair.is_vertical) return refuse(Code::kRectifyVertical, {first.name, second.name, program});
    const double left = result.pair.views[0].centre[0];
    const double right = result.pair.views[1].centre[0];
    constexpr double kLargestDifference = 1e-3;  // px
    if (std::abs(left - right) > kLargestDifference) return refuse(Code::kRectifyCentresDiffer, {left, right, program});
  } else if (first.image_size && *first.image_size != result.size) {
    return refuse(Code::kRectifySizesDiffer, {first.name, first.image_size->width, first.image_size->height,
                                              "the rectified pair", result.size.width, result.size.height});
  }
  if (name_of(request.layout) != kOrbSlam2) return true;
  for (const Camera& camera : result.cameras) {
    const std::string_view model = model_info(camera.model).id;
    if (model != "pinhole" && opencv_count(model) == 0) return refuse(Code::kRectifyModelNotKnown, {program, model});
  }
  return true;
}

/// Proves what its programs read from a file, and adds the proofs to the result. If a program reads something else than `rig`,
/// the result is rejected.
void prove_file(const ConvertedFile& file, const Written& written, const Rig& rig, RectifyResult& result) {
  ReadOptions reading;
  reading.opencv_model = written.opencv_model;
  reading.image_size = rig.cameras.front().image_size;
  const consumers::LoadOptions options = load_options(reading, written.sensor.empty() ? "mono" : written.sensor);
  for (const std::string& id : file.programs) {
    const consumers::Consumer* program = consumers::find_consumer(id);
    if (program == nullptr) continue;
    result.proofs.push_back(prove(*program, file.bytes, options, rig, file.cameras));
    if (!result.proofs.back().agrees()) result.status = worse(result.status, Status::kRejected);
  }
}

}  // namespace

std::vector<std::string> rectified_formats() {
  std::vector<std::string> ids;
  for (const Format& format : written_formats()) {
    if (format.rectified != RectifiedFiles::kNone) ids.emplace_back(format.id);
  }
  return ids;
}

bool write_settings(const RectifyRequest& request, const Calibration& input, RectifyResult& result) {
  const Format& to = *request.to;
  if (to.rectified == RectifiedFiles::kNone) {
    result.diagnostics.add(Code::kRectifyNoPlace, {to.title, rectified_formats()});
    return false;
  }
  if (!can_store(request, result, result.diagnostics)) return false;
  const bool images = to.rectified == RectifiedFiles::kImages;
  const Rig rig = images ? rig_of_images(input.rig, result) : rig_of_cameras(result);
  WriteOptions options;
  options.rewrite = true;
  options.layout = name_of(request.layout);
  options.extension = request.extension;
  std::optional<Written> written = write_calibration(to, nullptr, rig, options, result.diagnostics);
  if (!written) return false;
  if (!images && !written->states_rectification) {
    result.diagnostics.add(Code::kRectifyModelNotKnown, {to.program, model_info(result.cameras[0].model).id});
    return false;
  }
  ConvertRequest provenance;
  provenance.inputs = request.inputs;
  provenance.made_by = request.made_by;
  ConvertResult unused;
  add_provenance(provenance, input, *written, unused);
  result.mode = written->sensor;
  result.losses = written->losses;
  result.defaults = written->defaults;
  Rig rig_to_read = rig;
  for (const PoseEdge& edge : written->restated) rig_to_read.poses = {edge};
  for (const Written::File& file : written->files) {
    result.files.push_back({file.document.source().name, "", file.document.bytes(), file.document.syntax(), file.cameras,
                            file.programs, file.named, file.place, file.of_defaults});
    prove_file(result.files.back(), *written, rig_to_read, result);
  }
  return true;
}

}  // namespace fca
