// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/limits.h>

#include <fca/code.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace fca {

namespace {

/// What a rig's facts are called, and what is wrong with them.
class Findings {
 public:
  void add(const Argument& owner, Message problem) {
    if (problem.is_said()) problems_.push_back({Code::kRigOutOfRange, {owner, std::move(problem)}});
  }
  void add_unless_finite(const std::string& owner, const Argument& what, const std::optional<double>& value) {
    if (value && !std::isfinite(*value)) problems_.push_back({Code::kRigNumberNotFinite, {owner, what, *value}});
  }
  [[nodiscard]] std::vector<Message> problems() const { return problems_; }

 private:
  std::vector<Message> problems_;
};

void check(const Camera& camera, Findings& findings) {
  const std::span<const Parameter> parameters = model_info(camera.model).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    findings.add_unless_finite(camera.name, parameters[i].name, parameter_values(camera.model)[i]);
  }
  if (camera.image_size) findings.add(camera.name, problem_with_image_size(*camera.image_size));
  if (camera.time_offset_s) findings.add(camera.name, problem_with_time_offset(*camera.time_offset_s));
  findings.add_unless_finite(camera.name, Message{Code::kTheFrameRate}, camera.frame_rate_hz);
}

void check(const Imu& imu, Findings& findings) {
  findings.add_unless_finite(imu.name, Message{Code::kGyroscopeNoise}, imu.gyroscope_noise_density);
  findings.add_unless_finite(imu.name, Message{Code::kGyroscopeWalk}, imu.gyroscope_random_walk);
  findings.add_unless_finite(imu.name, Message{Code::kAccelerometerNoise}, imu.accelerometer_noise_density);
  findings.add_unless_finite(imu.name, Message{Code::kAccelerometerWalk}, imu.accelerometer_random_walk);
  findings.add_unless_finite(imu.name, Message{Code::kTheRate}, imu.rate_hz);
}

void check(const PoseEdge& edge, Findings& findings) {
  const std::string name = name_of(edge);
  findings.add(name, problem_with_rotation(edge.T_a_b));
  for (int row = 0; row < 3; ++row) findings.add(name, problem_with_translation(edge.T_a_b(row, 3)));
}

}  // namespace

Message problem_with_image_size(const ImageSize& size) {
  if (size.width < 1 || size.height < 1) return {Code::kImageOfNoSize, {size.width, size.height}};
  if (size.width <= kLargestImageSide && size.height <= kLargestImageSide) return {};
  return {Code::kImageTooLarge, {size.width, size.height, kLargestImageSide}};
}

Message problem_with_translation(double metres) {
  if (std::abs(metres) <= kLongestDistance) return {};
  return {Code::kTranslationTooLong, {metres, kLongestDistance}};
}

Message problem_with_baseline(double metres) {
  if (metres > 0.0 && metres < kLongestDistance) return {};
  return {Code::kBaselineImpossible, {metres, kLongestDistance}};
}

Message problem_with_time_offset(double seconds) {
  if (std::abs(seconds) <= kLongestTimeOffset) return {};
  return {Code::kTimeOffsetImpossible, {seconds, kLongestTimeOffset}};
}

Message problem_with_rotation(const Transform& T_a_b) {
  // First, so that what follows cannot overflow.
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double element = T_a_b(row, column);
      if (!(std::abs(element) <= kLargestRotationElement)) return {Code::kRotationElementTooLarge, {element}};
    }
  }
  // Whoever writes it may write its inverse, which is to be read again.
  const std::optional<Transform> back = inverse(T_a_b);
  const double defect = std::max(rotation_defect(T_a_b), back ? rotation_defect(*back) : 1.0);
  if (defect <= kCoarsestRotation) return {};
  return {Code::kNotOrthonormal, {defect}};
}

std::vector<Message> validate(const Rig& rig) {
  Findings findings;
  for (const Camera& camera : rig.cameras) check(camera, findings);
  for (const Imu& imu : rig.imus) check(imu, findings);
  for (const PoseEdge& edge : rig.poses) check(edge, findings);
  if (rig.baseline_m) findings.add(Message{Code::kTheRig}, problem_with_baseline(*rig.baseline_m));
  return findings.problems();
}

}  // namespace fca
