// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace fca {

namespace {

std::string spelled(double value, std::chars_format format = std::chars_format::general, int precision = 3) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
  return {buffer.data(), result.ptr};
}

/// "1000000"
std::string whole(double limit) { return spelled(limit, std::chars_format::fixed, 0); }

/// What a rig's facts are called, and what is wrong with them.
class Findings {
 public:
  void add(const std::string& what, const std::optional<std::string>& problem) {
    if (problem) problems_.push_back(what + ": " + *problem);
  }
  void add_unless_finite(const std::string& what, const std::optional<double>& value) {
    if (value && !std::isfinite(*value)) problems_.push_back(what + " is " + spelled(*value) + ", not a finite number");
  }
  [[nodiscard]] std::vector<std::string> problems() const { return problems_; }

 private:
  std::vector<std::string> problems_;
};

void check(const Camera& camera, Findings& findings) {
  const std::span<const Parameter> parameters = model_info(camera.model).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    findings.add_unless_finite(camera.name + ": " + std::string(parameters[i].name), parameter_values(camera.model)[i]);
  }
  if (camera.image_size) findings.add(camera.name, problem_with_image_size(*camera.image_size));
  if (camera.time_offset_s) findings.add(camera.name, problem_with_time_offset(*camera.time_offset_s));
  findings.add_unless_finite(camera.name + ": the frame rate", camera.frame_rate_hz);
}

void check(const Imu& imu, Findings& findings) {
  findings.add_unless_finite(imu.name + ": the gyroscope's noise density", imu.gyroscope_noise_density);
  findings.add_unless_finite(imu.name + ": the gyroscope's random walk", imu.gyroscope_random_walk);
  findings.add_unless_finite(imu.name + ": the accelerometer's noise density", imu.accelerometer_noise_density);
  findings.add_unless_finite(imu.name + ": the accelerometer's random walk", imu.accelerometer_random_walk);
  findings.add_unless_finite(imu.name + ": the rate", imu.rate_hz);
}

void check(const PoseEdge& edge, Findings& findings) {
  const std::string name = "T_" + edge.a + "_" + edge.b;
  findings.add(name, problem_with_rotation(edge.T_a_b));
  for (int row = 0; row < 3; ++row) findings.add(name, problem_with_translation(edge.T_a_b(row, 3)));
}

}  // namespace

std::optional<std::string> problem_with_image_size(const ImageSize& size) {
  const std::string what =
      "an image of " + std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels cannot be";
  if (size.width < 1 || size.height < 1) return what;
  if (size.width <= kLargestImageSide && size.height <= kLargestImageSide) return std::nullopt;
  const std::string side = std::to_string(kLargestImageSide);
  return what + ": no image is larger than " + side + " x " + side;
}

std::optional<std::string> problem_with_translation(double metres) {
  if (std::abs(metres) <= kLongestDistance) return std::nullopt;
  return "a translation of " + spelled(metres) + " m; no rig is longer than " + whole(kLongestDistance) + " m";
}

std::optional<std::string> problem_with_baseline(double metres) {
  if (metres > 0.0 && metres < kLongestDistance) return std::nullopt;
  return "a baseline of " + spelled(metres) + " m; it must be greater than 0 and less than " + whole(kLongestDistance) + " m";
}

std::optional<std::string> problem_with_time_offset(double seconds) {
  if (std::abs(seconds) <= kLongestTimeOffset) return std::nullopt;
  return "a time offset of " + spelled(seconds) + " s; it must lie within " + whole(kLongestTimeOffset) + " s";
}

std::optional<std::string> problem_with_rotation(const Transform& T_a_b) {
  const std::string what = "its 3 x 3 part is not a rotation, ";
  // First, so that what follows cannot overflow.
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double element = T_a_b(row, column);
      if (!(std::abs(element) <= kLargestRotationElement)) return what + "an element is " + spelled(element);
    }
  }
  // Whoever writes it may write its inverse, which is to be read again.
  const std::optional<Transform> back = inverse(T_a_b);
  const double defect = std::max(rotation_defect(T_a_b), back ? rotation_defect(*back) : 1.0);
  if (defect <= kCoarsestRotation) return std::nullopt;
  return what + "R^T R differs from the identity by " + spelled(defect);
}

std::vector<std::string> validate(const Rig& rig) {
  Findings findings;
  for (const Camera& camera : rig.cameras) check(camera, findings);
  for (const Imu& imu : rig.imus) check(imu, findings);
  for (const PoseEdge& edge : rig.poses) check(edge, findings);
  if (rig.baseline_m) findings.add("rig", problem_with_baseline(*rig.baseline_m));
  return findings.problems();
}

}  // namespace fca
