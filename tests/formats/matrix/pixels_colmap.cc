// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's cameras.txt: words after an id, a model and a size, in the order of MORE-FORMATS.md section 2, with the first
// pixel's centre at (0.5, 0.5). COLMAP itself stops at 90 deg from the axis, where the formulas of its fisheyes go on.
#include "pixels_colmap.h"

#include "sensor_lens.h"

#include <rapidjson/document.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <utility>

namespace fca::matrix::colmap {

namespace {

struct Kind {
  bool one_focal_length = false;
  bool equidistant = false;
  std::size_t coefficients = 0;
};

const std::map<std::string, Kind> kKinds = {{"SIMPLE_PINHOLE", {true, false, 0}},
                                            {"PINHOLE", {false, false, 0}},
                                            {"SIMPLE_RADIAL", {true, false, 1}},
                                            {"RADIAL", {true, false, 2}},
                                            {"OPENCV", {false, false, 4}},
                                            {"FULL_OPENCV", {false, false, 8}},
                                            {"OPENCV_FISHEYE", {false, true, 4}},
                                            {"FISHEYE", {false, true, 0}},
                                            {"SIMPLE_RADIAL_FISHEYE", {true, true, 1}},
                                            {"RADIAL_FISHEYE", {true, true, 2}},
                                            {"SIMPLE_FISHEYE", {true, true, 0}},
                                            {"FOV", {false, false, 1}},
                                            {"EUCM", {false, false, 2}},
                                            {"DIVISION", {false, false, 1}},
                                            {"SIMPLE_DIVISION", {true, false, 1}},
                                            {"THIN_PRISM_FISHEYE", {false, true, 8}},
                                            {"RAD_TAN_THIN_PRISM_FISHEYE", {false, true, 12}}};

RayToPixel fov_lens(const std::vector<double>& k, double w) {
  return [k, w](const Ray& ray) -> std::optional<Pixel> {
    const double r = std::hypot(ray[0], ray[1]);
    const double tangent = 2.0 * std::tan(w / 2.0);
    if (r == 0.0) return ray[2] > 0.0 ? std::optional(Pixel{k[2], k[3]}) : std::nullopt;
    const double bent = std::atan2(tangent * r, ray[2]) / w;
    return Pixel{k[0] * bent * ray[0] / r + k[2], k[1] * bent * ray[1] / r + k[3]};
  };
}

RayToPixel eucm_lens(const std::vector<double>& k, double alpha, double beta) {
  return [k, alpha, beta](const Ray& ray) -> std::optional<Pixel> {
    const double depth = std::sqrt(beta * (ray[0] * ray[0] + ray[1] * ray[1]) + ray[2] * ray[2]);
    const double down = alpha * depth + (1.0 - alpha) * ray[2];
    // Usenko, Demmel, Cremers 2018, eq. 15: z > -w d.
    const double w = alpha <= 0.5 ? alpha / (1.0 - alpha) : (1.0 - alpha) / alpha;
    if (!(ray[2] > -w * depth) || !(down > 0.0)) return std::nullopt;
    return Pixel{k[0] * ray[0] / down + k[2], k[1] * ray[1] / down + k[3]};
  };
}

/// The plane's radius is r / (1 + k r^2) (MORE-FORMATS-2.md section 17).
RayToPixel division_lens(const std::vector<double>& k, double bend) {
  return [k, bend](const Ray& ray) -> std::optional<Pixel> {
    if (!(ray[2] > 0.0)) return std::nullopt;
    const double radius = std::hypot(ray[0], ray[1]) / ray[2];
    const double r = radius > 0.0 ? (1.0 - std::sqrt(1.0 - 4.0 * bend * radius * radius)) / (2.0 * bend * radius) : 0.0;
    const double factor = radius > 0.0 ? r / radius / ray[2] : 0.0;
    return Pixel{k[0] * ray[0] * factor + k[2], k[1] * ray[1] * factor + k[3]};
  };
}

/// Section 17: all terms of the angle's plane, in the order k1 k2 p1 p2 k3 k4 sx1 sy1.
Pixel thin_prism(const std::vector<double>& d, double x, double y) {
  const double q = x * x + y * y;
  const double bent = 1.0 + d[0] * q + d[1] * std::pow(q, 2) + d[4] * std::pow(q, 3) + d[5] * std::pow(q, 4);
  return {x * bent + 2.0 * d[2] * x * y + d[3] * (3.0 * x * x + y * y) + d[6] * q,
          y * bent + 2.0 * d[3] * x * y + d[2] * (x * x + 3.0 * y * y) + d[7] * q};
}

/// Section 25.1: k0 .. k5 first, then p0 p1 s0 .. s3 of what those made.
Pixel fisheye624(const std::vector<double>& d, double x, double y) {
  const double t = x * x + y * y;
  double bent = 1.0;
  for (std::size_t i = 0; i < 6; ++i) bent += d[i] * std::pow(t, static_cast<double>(i) + 1.0);
  x *= bent;
  y *= bent;
  const double q = x * x + y * y;
  return {x + d[6] * (2.0 * x * x + q) + 2.0 * d[7] * x * y + d[8] * q + d[9] * q * q,
          y + d[7] * (2.0 * y * y + q) + 2.0 * d[6] * x * y + d[10] * q + d[11] * q * q};
}

RayToPixel prism_lens(const std::vector<double>& k, const std::vector<double>& d) {
  return [k, d](const Ray& ray) -> std::optional<Pixel> {
    const double r = std::hypot(ray[0], ray[1]);
    if (r == 0.0 && !(ray[2] > 0.0)) return std::nullopt;
    const double scale = r > 0.0 ? std::atan2(r, ray[2]) / r : 1.0 / ray[2];
    const Pixel point = (d.size() == 8 ? thin_prism : fisheye624)(d, scale * ray[0], scale * ray[1]);
    return Pixel{k[0] * point[0] + k[2], k[1] * point[1] + k[3]};
  };
}

RayToPixel lens(const std::string& model, const Kind& kind, const std::vector<double>& k, const std::vector<double>& d) {
  if (model == "FOV") return fov_lens(k, d[0]);
  if (model == "EUCM") return eucm_lens(k, d[0], d[1]);
  if (model == "DIVISION" || model == "SIMPLE_DIVISION") return division_lens(k, d[0]);
  if (model == "THIN_PRISM_FISHEYE" || model == "RAD_TAN_THIN_PRISM_FISHEYE") return prism_lens(k, d);
  return sensor_lens(k, d, kind.equidistant);
}

/// Of a line, or of an object of rig_config.json.
std::optional<PixelFormula> formula_of(const std::string& model, std::vector<double> numbers) {
  if (!kKinds.contains(model)) return std::nullopt;
  const Kind& kind = kKinds.at(model);
  if (kind.one_focal_length && !numbers.empty()) numbers.insert(numbers.begin(), numbers.front());
  if (numbers.size() != 4 + kind.coefficients) return std::nullopt;
  const std::vector<double> k = {numbers[0], numbers[1], numbers[2] - 0.5, numbers[3] - 0.5};
  PixelFormula formula;
  formula.pixel = lens(model, kind, k, {numbers.begin() + 4, numbers.end()});
  return formula;
}

rapidjson::Document rigs_in(const std::string& bytes) {
  rapidjson::Document rigs;
  rigs.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str());
  return rigs;
}

std::optional<PixelFormula> camera_of_rig(const std::string& bytes, std::size_t index) {
  const rapidjson::Document rigs = rigs_in(bytes);
  for (const rapidjson::Value& rig : rigs.GetArray()) {
    for (const rapidjson::Value& camera : rig["cameras"].GetArray()) {
      if (index-- > 0) continue;
      if (!camera.HasMember("camera_params")) return std::nullopt;
      std::vector<double> numbers;
      for (const rapidjson::Value& number : camera["camera_params"].GetArray()) numbers.push_back(number.GetDouble());
      return formula_of(camera["camera_model_name"].GetString(), numbers);
    }
  }
  return std::nullopt;
}

constexpr std::size_t kOfCount = 8;

bool is_binary(const std::string& bytes) {
  return bytes.size() > kOfCount && bytes.compare(kOfCount / 2, kOfCount / 2, std::string(kOfCount / 2, '\0')) == 0;
}

/// The names of models by their numbers, and how many parameters they have (MORE-FORMATS.md section 2).
const std::vector<std::pair<std::string, std::size_t>> kNumbered = {{"SIMPLE_PINHOLE", 3},
                                                                    {"PINHOLE", 4},
                                                                    {"SIMPLE_RADIAL", 4},
                                                                    {"RADIAL", 5},
                                                                    {"OPENCV", 8},
                                                                    {"OPENCV_FISHEYE", 8},
                                                                    {"FULL_OPENCV", 12},
                                                                    {"FOV", 5},
                                                                    {"SIMPLE_RADIAL_FISHEYE", 4},
                                                                    {"RADIAL_FISHEYE", 5},
                                                                    {"THIN_PRISM_FISHEYE", 12},
                                                                    {"RAD_TAN_THIN_PRISM_FISHEYE", 16},
                                                                    {"SIMPLE_DIVISION", 4},
                                                                    {"DIVISION", 5},
                                                                    {"SIMPLE_FISHEYE", 3},
                                                                    {"FISHEYE", 4},
                                                                    {"EUCM", 6}};

/// A number at that place, on a little endian machine.
template <class T>
T number_at(const std::string& bytes, std::size_t at) {
  T number{};
  std::memcpy(&number, bytes.data() + at, sizeof(T));
  return number;
}

std::optional<PixelFormula> binary_camera(const std::string& bytes, std::size_t index) {
  constexpr std::size_t kFixed = 24;
  std::size_t at = kOfCount;
  for (; at + kFixed <= bytes.size(); --index) {
    const auto& [model, count] = kNumbered.at(number_at<std::uint32_t>(bytes, at + 4));
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(number_at<double>(bytes, at + kFixed + i * sizeof(double)));
    if (index == 0) {
      std::optional<PixelFormula> formula = formula_of(model, numbers);
      Size size;
      size.width = static_cast<int>(number_at<std::uint64_t>(bytes, at + 8));
      size.height = static_cast<int>(number_at<std::uint64_t>(bytes, at + 16));
      if (formula) formula->size = size;
      return formula;
    }
    at += kFixed + count * sizeof(double);
  }
  return std::nullopt;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  if (bytes.starts_with('[')) return camera_of_rig(bytes, index);
  if (is_binary(bytes)) return binary_camera(bytes, index);
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#' || index-- > 0) continue;
    std::istringstream words(line);
    long id = 0;
    std::string model;
    Size size;
    if (!(words >> id >> model >> size.width >> size.height)) return std::nullopt;
    std::vector<double> numbers;
    for (double number = 0.0; words >> number;) numbers.push_back(number);
    std::optional<PixelFormula> formula = formula_of(model, numbers);
    if (formula) formula->size = size;
    return formula;
  }
  return std::nullopt;
}

/// The second camera's pose in rig_config.json takes points of the first, its reference. The columns are the images of the
/// axes: q e q*.
std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  const auto file = std::ranges::find_if(files, [](const std::string& bytes) { return bytes.starts_with('['); });
  if (file == files.end()) return {};
  const rapidjson::Document rigs = rigs_in(*file);
  const rapidjson::Value& camera = rigs[0]["cameras"][1];
  if (!camera.HasMember("cam_from_rig_rotation")) return {};
  const auto number = [&camera](const char* key, std::size_t i) {
    return camera[key][static_cast<rapidjson::SizeType>(i)].GetDouble();
  };
  const double w = number("cam_from_rig_rotation", 0);
  Pose pose{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t b = (axis + 1) % 3;
    const std::size_t c = (axis + 2) % 3;
    const auto q = [&number](std::size_t i) { return number("cam_from_rig_rotation", i + 1); };
    pose[axis][axis] = w * w + q(axis) * q(axis) - q(b) * q(b) - q(c) * q(c);
    pose[b][axis] = 2.0 * (q(axis) * q(b) + w * q(c));
    pose[c][axis] = 2.0 * (q(axis) * q(c) - w * q(b));
    pose[axis][3] = number("cam_from_rig_translation", axis);
  }
  return {pose};
}

}  // namespace fca::matrix::colmap
