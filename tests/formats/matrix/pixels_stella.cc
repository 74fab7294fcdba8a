// SPDX-License-Identifier: BSD-3-Clause
// stella_vslam's configuration as its camera/*.cc and util/stereo_rectifier.cc read it (MORE-FORMATS.md section 10,
// MORE-FORMATS-2.md section 24), in the formulas of OpenCV and of the division model. Keys with a point are OpenVSLAM's.
#include "pixels_stella.h"

#include "sensor_lens.h"

#include <yaml-cpp/yaml.h>

namespace fca::matrix::stella {

namespace {

YAML::Node at(const YAML::Node& root, const std::string& block, const std::string& key) {
  if (root[block + "." + key]) return root[block + "." + key];
  return root[block] ? root[block][key] : YAML::Node(YAML::NodeType::Undefined);
}

double number(const YAML::Node& root, const std::string& key) { return at(root, "Camera", key).as<double>(); }

std::vector<double> list(const YAML::Node& root, const std::string& key) {
  return at(root, "StereoRectifier", key).as<std::vector<double>>();
}

/// The pixel (x, y) whose ray is (x, y, 1 + d r^2), found by bisection of the radius.
RayToPixel division(const std::vector<double>& k, double d) {
  return [k, d](const Ray& ray) -> std::optional<Pixel> {
    const double across = std::hypot(ray[0], ray[1]);
    if (across == 0.0) return ray[2] > 0.0 ? std::optional(Pixel{k[2], k[3]}) : std::nullopt;
    const double wanted = std::atan2(across, ray[2]);
    double low = 0.0;
    double high = d > 0.0 ? 1.0 / std::sqrt(d) : 1e6;
    if (wanted >= std::atan2(high, 1.0 + d * high * high)) return std::nullopt;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (std::atan2(middle, 1.0 + d * middle * middle) < wanted ? low : high) = middle;
    }
    return Pixel{k[0] * low * ray[0] / across + k[2], k[1] * low * ray[1] / across + k[3]};
  };
}

std::optional<Pose> pose(const YAML::Node& root, const std::string& side, double right_of_left) {
  const std::vector<double> r = list(root, "R_" + side);
  return Pose{{{r[0], r[1], r[2], right_of_left}, {r[3], r[4], r[5], 0.0}, {r[6], r[7], r[8], 0.0}}};
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const YAML::Node root = YAML::Load(bytes);
  const YAML::Node K = at(root, "StereoRectifier", "K_left");
  if (index > (K.IsDefined() ? 1U : 0U)) return std::nullopt;
  PixelFormula formula;
  formula.size = Size{static_cast<int>(number(root, "cols")), static_cast<int>(number(root, "rows"))};
  if (K.IsDefined()) {
    const std::string side = index == 0 ? "left" : "right";
    const std::vector<double> k = list(root, "K_" + side);
    const YAML::Node model = at(root, "StereoRectifier", "model");
    const bool fisheye = model.IsDefined() && model.as<std::string>() == "fisheye";
    formula.pixel = sensor_lens({k[0], k[4], k[2], k[5]}, list(root, "D_" + side), fisheye);
    return formula;
  }
  if (at(root, "Camera", "model").as<std::string>() == "equirectangular") {
    formula.pixel = [size = *formula.size](const Ray& ray) -> std::optional<Pixel> {
      const double pi = std::acos(-1.0);
      const double latitude = -std::asin(ray[1] / std::hypot(ray[0], ray[1], ray[2]));
      return Pixel{size.width * (0.5 + std::atan2(ray[0], ray[2]) / (2.0 * pi)), size.height * (0.5 - latitude / pi)};
    };
    return formula;
  }
  const std::vector<double> k = {number(root, "fx"), number(root, "fy"), number(root, "cx"), number(root, "cy")};
  const std::string model = at(root, "Camera", "model").as<std::string>();
  if (model == "perspective") {
    std::vector<double> d;
    for (const char* key : {"k1", "k2", "p1", "p2", "k3"}) d.push_back(number(root, key));
    formula.pixel = sensor_lens(k, d, false);
  } else if (model == "fisheye") {
    std::vector<double> d;
    for (const char* key : {"k1", "k2", "k3", "k4"}) d.push_back(number(root, key));
    formula.pixel = sensor_lens(k, d, true);
  } else if (model == "radial_division") {
    formula.pixel = division(k, number(root, "distortion"));
  } else {
    return std::nullopt;
  }
  return formula;
}

/// p_rectified_left = R_left p_left = R_right p_right + (baseline, 0, 0)
std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  const YAML::Node root = YAML::Load(files.front());
  if (!at(root, "StereoRectifier", "K_left").IsDefined()) return {};
  const std::optional<Pose> left = pose(root, "left", 0.0);
  const std::optional<Pose> right = pose(root, "right", number(root, "focal_x_baseline") / number(root, "fx"));
  return {inverse(*right) * *left};
}

}  // namespace fca::matrix::stella
