// SPDX-License-Identifier: BSD-3-Clause
// EuRoC's sensor.yaml by yaml-cpp, in the formulas that its distortion_model names (MORE-FORMATS.md section 7), but for
// cuVSLAM's files with camera_model fisheye, which are equidistant (MORE-FORMATS-2.md section 19).
#include "pixels_euroc.h"

#include "sensor_lens.h"

#include <yaml-cpp/yaml.h>

namespace fca::matrix::euroc {

namespace {

/// A null node of what is no YAML; OpenCV's header is none.
YAML::Node load(std::string bytes) {
  if (bytes.starts_with("%YAML:")) bytes[0] = '#';
  try {
    return YAML::Load(bytes);
  } catch (const YAML::Exception&) {
    return {};
  }
}

std::vector<double> numbers(const YAML::Node& list) {
  std::vector<double> values;
  if (!list.IsSequence()) return values;
  for (const YAML::Node& item : list) values.push_back(item.as<double>());
  return values;
}

/// T_body_camera, or that in cam0: either frame is the same for all files.
std::optional<Pose> pose_in_body(const std::string& bytes) {
  const YAML::Node root = load(bytes);
  if (!root.IsMap() || !root["intrinsics"]) return std::nullopt;
  for (const char* key : {"T_BS", "T_Cam0"}) {
    if (!root[key]) continue;
    const std::vector<double> data = numbers(root[key]["data"]);
    Pose pose{};
    for (std::size_t i = 0; i < 12 && data.size() == 16; ++i) pose[i / 4][i % 4] = data[i];
    return pose;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const YAML::Node root = load(bytes);
  if (index > 0 || !root.IsMap() || !root["distortion_model"] || !root["camera_model"]) return std::nullopt;
  const std::vector<double> k = numbers(root["intrinsics"]);
  const std::vector<double> size = numbers(root["resolution"]);
  if (k.size() != 4 || size.size() != 2) return std::nullopt;
  const auto model = root["distortion_model"].as<std::string>();
  const bool equidistant = model == "equidistant" || root["camera_model"].as<std::string>() == "fisheye";
  PixelFormula formula;
  formula.size = Size{static_cast<int>(size[0]), static_cast<int>(size[1])};
  formula.pixel = sensor_lens(k, numbers(root["distortion_coefficients"]), equidistant);
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) { return second_in_first(files, &pose_in_body); }

}  // namespace fca::matrix::euroc
