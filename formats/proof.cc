// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/proof.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca {

namespace {

constexpr std::array kSensorModes = {"mono", "stereo", "rgbd", "mono-inertial", "stereo-inertial", "rgbd-inertial"};

struct Comparison {
  double worst = 0.0;
  double misread = 0.0;
  int asked = 0;
  int compared = 0;
  bool agrees = true;
};

/// Over the camera's image: our ray of a pixel, then the program's pixel of that ray.
void compare_camera(const Camera& ours, const consumers::ConsumerCamera& theirs, double tolerance, Comparison& result) {
  if (!ours.image_size) return;
  constexpr int kSteps = 40;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Pixel pixel = {(ours.image_size->width - 1.0) * i / kSteps, (ours.image_size->height - 1.0) * j / kSteps};
      const std::optional<Ray> ray = unproject(ours.model, pixel);
      if (!ray) continue;
      ++result.asked;
      const std::optional<std::array<double, 2>> image = theirs.project(*ray);
      if (!image) continue;
      // Beyond 90 degrees some programs mirror: that is their limit, told as a warning, not a fault of the file.
      if ((*ray)[2] <= 0.0 && std::hypot((*image)[0] / theirs.scale[0] - pixel[0], (*image)[1] / theirs.scale[1] - pixel[1]) > 1.0) continue;
      ++result.compared;
      const double difference = std::hypot((*image)[0] - pixel[0] * theirs.scale[0], (*image)[1] - pixel[1] * theirs.scale[1]);
      if (theirs.misread) {
        result.misread = std::max(result.misread, difference);
        continue;
      }
      result.worst = std::max(result.worst, difference);
      const double allowed = tolerance * std::max({1.0, std::abs(pixel[0]) / 1000.0, std::abs(pixel[1]) / 1000.0});
      if (!(difference <= allowed)) result.agrees = false;
    }
  }
}

double pose_difference(const Rig& rig, const consumers::ConsumerPose& pose) {
  const std::optional<Transform> T = rig.resolve(pose.a, pose.b);
  if (!T) return 0.0;
  double worst = 0.0;
  for (std::size_t i = 0; i < T->values.size(); ++i) worst = std::max(worst, std::abs(T->values[i] - pose.T_a_b[i]));
  return worst;
}

}  // namespace

ProofResult prove(const consumers::Consumer& consumer, std::string_view bytes, const consumers::LoadOptions& options, const Rig& rig) {
  const consumers::ConsumerView view = consumer.load(bytes, options);
  ProofResult result;
  result.program = consumer.program;
  result.loads = view.loads();
  result.refusals = view.refusals;
  result.warnings = view.warnings;
  if (!result.loads) return result;
  // The rig's cameras by position: formats may rename them.
  Comparison comparison;
  for (std::size_t i = 0; i < std::min(rig.cameras.size(), view.cameras.size()); ++i) {
    compare_camera(rig.cameras[i], view.cameras[i], consumer.tolerance_px, comparison);
  }
  result.max_diff_px = comparison.worst;
  result.misread_px = comparison.misread;
  result.compared_share = comparison.asked > 0 ? static_cast<double>(comparison.compared) / comparison.asked : 0.0;
  constexpr double kPosePrecision = 1e-6;  // float formats
  for (const consumers::ConsumerPose& pose : view.poses) result.max_diff_pose = std::max(result.max_diff_pose, pose_difference(rig, pose));
  result.agrees = comparison.agrees && comparison.compared > 0 && result.max_diff_pose <= kPosePrecision;
  return result;
}

bool Readers::any_loads() const { return std::ranges::any_of(programs, &Program::loads); }

Readers ask_readers(std::string_view format, std::string_view bytes, std::optional<bool> with_cameras) {
  Readers readers;
  for (const consumers::Consumer& consumer : consumers::all_consumers()) {
    if (consumer.format != format || (with_cameras && consumer.cameras != *with_cameras)) continue;
    Readers::Program program;
    program.program = consumer.program;
    std::size_t fewest = SIZE_MAX;
    for (const char* mode : kSensorModes) {
      const consumers::ConsumerView view = consumer.load(bytes, {mode});
      if (view.loads()) {
        if (!program.loads) program.warnings = view.warnings;
        program.loads = true;
        program.sensors.emplace_back(mode);
      } else if (view.refusals.size() < fewest) {
        fewest = view.refusals.size();
        program.refusals = view.refusals;
      }
      if (format != "orbslam3") break;  // the others have no modes
    }
    if (program.loads) program.refusals.clear();
    if (format != "orbslam3") program.sensors.clear();
    readers.programs.push_back(std::move(program));
  }
  return readers;
}

}  // namespace fca
