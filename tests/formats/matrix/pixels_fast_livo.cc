// SPDX-License-Identifier: BSD-3-Clause
// FAST-LIVO's camera as rpg_vikit's camera_loader.h reads it (MORE-FORMATS-2.md section 22), of the images as they come: scale
// shrinks these, and all numbers with them. In the formulas of OpenCV, and of Devernay and Faugeras' FOV model.
#include "pixels_fast_livo.h"

#include "sensor_lens.h"

#include <yaml-cpp/yaml.h>

namespace fca::matrix::fast_livo {

namespace {

/// The mapping that has the camera's keys.
YAML::Node keys_of(const YAML::Node& root) {
  if (!root.IsMap() || root["cam_model"]) return root;
  for (const auto& entry : root) {
    if (entry.second.IsMap()) return keys_of(entry.second);
  }
  return root;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const YAML::Node keys = keys_of(YAML::Load(bytes));
  if (index > 0 || !keys["cam_model"]) return std::nullopt;
  const auto number = [&keys](const std::string& key) { return keys[key] ? keys[key].as<double>() : 0.0; };
  const std::string model = keys["cam_model"].as<std::string>();
  PixelFormula formula;
  formula.size = Size{keys["cam_width"].as<int>(), keys["cam_height"].as<int>()};
  std::vector<double> k = {number("cam_fx"), number("cam_fy"), number("cam_cx"), number("cam_cy")};
  if (model == "Pinhole") {
    formula.pixel = sensor_lens(k, {number("cam_d0"), number("cam_d1"), number("cam_d2"), number("cam_d3")}, false);
  } else if (model == "EquidistantCamera") {
    formula.pixel = sensor_lens(k, {number("k1"), number("k2"), number("k3"), number("k4")}, true);
  } else if (model == "ATAN") {
    const double w = formula.size->width;
    const double h = formula.size->height;
    k = {k[0] * w, k[1] * h, k[2] * w - 0.5, k[3] * h - 0.5};
    const double angle = number("cam_d0");
    formula.pixel = [k, angle](const Ray& ray) -> std::optional<Pixel> {
      const double across = std::hypot(ray[0], ray[1]);
      if (across == 0.0) return ray[2] > 0.0 ? std::optional(Pixel{k[2], k[3]}) : std::nullopt;
      const double radius = std::atan2(2.0 * across * std::tan(angle / 2.0), ray[2]) / angle;
      return Pixel{k[0] * radius * ray[0] / across + k[2], k[1] * radius * ray[1] / across + k[3]};
    };
  } else {
    return std::nullopt;
  }
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& /*files*/) { return {}; }

}  // namespace fca::matrix::fast_livo
