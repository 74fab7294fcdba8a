// SPDX-License-Identifier: BSD-3-Clause
// ncamera files as SVO and maplab compute with them (MORE-FORMATS.md section 9): fov after Devernay and Faugeras 2001, the
// unified projection after Mei and Rives 2007, omni as the OCamCalib toolbox's cam2world and world2cam. Where the programs
// divide by z and so end at 90 deg, the angle is taken here.
#include "pixels_ncamera.h"

#include "sensor_lens.h"

#include <yaml-cpp/yaml.h>

namespace fca::matrix::ncamera {

namespace {

void flatten(const YAML::Node& node, std::vector<double>& into) {
  if (!node) return;
  if (node.IsScalar()) {
    into.push_back(node.as<double>());
    return;
  }
  for (const YAML::Node& item : node) flatten(item, into);
}

std::vector<double> matrix(const YAML::Node& node) {
  std::vector<double> numbers;
  if (node && node.IsMap()) flatten(node["data"], numbers);
  return numbers;
}

/// The entry of the list of cameras; a camera without a list is the only one.
YAML::Node entry_of(const std::string& bytes, std::size_t index) {
  const YAML::Node root = YAML::Load(bytes);
  if (!root.IsMap()) return {};
  if (root["intrinsics"]) {
    YAML::Node entry;
    if (index == 0) entry["camera"] = root;
    return entry;
  }
  YAML::Node cameras;
  if (root["cameras"]) cameras.reset(root["cameras"]);
  for (const YAML::Node& sensor : root["sensors"]) {
    if (sensor["sensor_type"].as<std::string>() == "NCAMERA") cameras.reset(sensor["cameras"]);
  }
  if (!cameras.IsSequence() || index >= cameras.size()) return {};
  return cameras[index];
}

RayToPixel fov(const std::vector<double>& k, double w) {
  return [k, w](const Ray& ray) -> std::optional<Pixel> {
    const double r = std::hypot(ray[0], ray[1]);
    if (r == 0.0) return ray[2] > 0.0 ? std::optional(Pixel{k[2], k[3]}) : std::nullopt;
    const double radius = std::atan2(2.0 * r * std::tan(0.5 * w), ray[2]) / w;
    return Pixel{k[0] * radius * ray[0] / r + k[2], k[1] * radius * ray[1] / r + k[3]};
  };
}

RayToPixel mei(const std::vector<double>& k, const std::vector<double>& d) {
  const RayToPixel plane = sensor_lens({k[1], k[2], k[3], k[4]}, d, false);
  return [plane, xi = k[0]](const Ray& ray) -> std::optional<Pixel> {
    const double length = std::hypot(ray[0], ray[1], ray[2]);
    if (ray[2] <= -(xi <= 1.0 ? xi : 1.0 / xi) * length) return std::nullopt;
    return plane({ray[0], ray[1], ray[2] + xi * length});
  };
}

double at(const double* coefficients, std::size_t count, double x) {
  double result = 0.0;
  for (std::size_t i = count; i-- > 0;) result = result * x + coefficients[i];
  return result;
}

/// u = x + e y + cx, v = d x + c y + cy.
Pixel placed(const std::vector<double>& k, double x, double y) { return {x + k[9] * y + k[5], k[8] * x + k[7] * y + k[6]}; }

/// The first radius at which the direct polynomial has that angle, walking outwards as long as it grows.
std::optional<double> radius_of(const std::vector<double>& k, double angle, double limit) {
  const auto angle_at = [&k](double rho) { return std::atan2(rho, -at(k.data(), 5, rho)); };
  const double step = limit / 512.0;
  for (double rho = 0.0; rho < limit; rho += step) {
    if (angle_at(rho + step) < angle_at(rho)) return std::nullopt;
    if (angle_at(rho + step) < angle) continue;
    double low = rho;
    double high = rho + step;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (angle_at(middle) < angle ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  return std::nullopt;
}

void set_omni(PixelFormula& formula, const std::vector<double>& k, const Size& size) {
  const double limit = 1.5 * std::hypot(size.width, size.height);
  formula.pixel = [k, limit](const Ray& ray) -> std::optional<Pixel> {
    const double r = std::hypot(ray[0], ray[1]);
    if (r == 0.0) return ray[2] > 0.0 ? std::optional(Pixel{k[5], k[6]}) : std::nullopt;
    const std::optional<double> rho = radius_of(k, std::atan2(r, ray[2]), limit);
    if (!rho) return std::nullopt;
    return placed(k, *rho * ray[0] / r, *rho * ray[1] / r);
  };
  formula.ray = [k](const Pixel& pixel) -> std::optional<Ray> {
    const double u = pixel[0] - k[5];
    const double v = pixel[1] - k[6];
    const double down = k[7] - k[8] * k[9];
    const double x = (k[7] * u - k[9] * v) / down;
    const double y = (v - k[8] * u) / down;
    // Beyond the place where the angle stops growing there is no lens.
    const double rho = std::hypot(x, y);
    double angle = 0.0;
    for (int i = 1; i <= 256; ++i) {
      const double next = std::atan2(rho * i / 256.0, -at(k.data(), 5, rho * i / 256.0));
      if (next < angle) return std::nullopt;
      angle = next;
    }
    return Ray{x, y, -at(k.data(), 5, rho)};
  };
  formula.stored_approximation = [k](const Ray& ray) -> std::optional<Pixel> {
    const double r = std::hypot(ray[0], ray[1]);
    if (r == 0.0) return placed(k, 0.0, 0.0);
    const double rho = at(k.data() + 10, 12, std::atan(-ray[2] / r));
    return placed(k, rho * ray[0] / r, rho * ray[1] / r);
  };
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  try {
    const YAML::Node entry = entry_of(bytes, index);
    if (!entry || !entry.IsMap()) return std::nullopt;
    const YAML::Node node = entry["camera"];
    const std::vector<double> k = matrix(node["intrinsics"]);
    const YAML::Node distortion = node["distortion"];
    const std::vector<double> d = distortion ? matrix(distortion["parameters"]) : std::vector<double>();
    const std::string bend = distortion ? distortion["type"].as<std::string>() : "none";
    const std::string type = node["type"].as<std::string>();
    PixelFormula formula;
    formula.size = Size{node["image_width"].as<int>(), node["image_height"].as<int>()};
    if (type == "omni" && k.size() == 24) {
      set_omni(formula, k, *formula.size);
    } else if (type == "unified-projection" && k.size() == 5) {
      formula.pixel = mei(k, d);
    } else if (type == "pinhole" && k.size() == 4 && bend == "fisheye" && d.size() == 1) {
      formula.pixel = fov(k, d[0]);
    } else if (type == "pinhole" && k.size() == 4) {
      formula.pixel = sensor_lens(k, d, bend == "equidistant");
    } else {
      return std::nullopt;
    }
    return formula;
  } catch (const YAML::Exception&) {
    return std::nullopt;
  }
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  for (const std::string& bytes : files) {
    std::vector<Pose> in_body;
    for (std::size_t i = 0; i < 2; ++i) {
      try {
        const YAML::Node entry = entry_of(bytes, i);
        if (!entry || !entry.IsMap()) continue;
        const bool turned = !entry["T_B_C"];
        const std::vector<double> numbers = matrix(turned ? entry["T_C_B"] : entry["T_B_C"]);
        if (numbers.size() != 16) continue;
        Pose pose{};
        for (std::size_t k = 0; k < 12; ++k) pose[k / 4][k % 4] = numbers[k];
        in_body.push_back(turned ? inverse(pose) : pose);
      } catch (const YAML::Exception&) {
        continue;
      }
    }
    if (in_body.size() == 2) return {inverse(in_body[1]) * in_body[0]};
  }
  return {};
}

}  // namespace fca::matrix::ncamera
