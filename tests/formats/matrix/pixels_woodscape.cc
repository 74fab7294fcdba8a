// SPDX-License-Identifier: BSD-3-Clause
// WoodScape's JSON as the dataset's scripts/calibration/projection.py computes with it (valeoai/WoodScape@597d9dd; FORMATS.md
// section 6): rho = k1 t + k2 t^2 + k3 t^3 + k4 t^4 in pixels, t the angle from the axis; the centre is size / 2 - 0.5 + offset
// with the size cast to int; the aspect ratio acts on v. Pose: quaternion x y z w, camera to vehicle.
#include "pixels_woodscape.h"

#include <rapidjson/document.h>

namespace fca::matrix::woodscape {

namespace {

const rapidjson::Value* member(const rapidjson::Value& object, const char* key) {
  if (!object.IsObject()) return nullptr;
  const auto found = object.FindMember(key);
  return found == object.MemberEnd() ? nullptr : &found->value;
}

bool read_numbers(const rapidjson::Value& object, std::initializer_list<std::pair<const char*, double*>> wanted) {
  for (const auto& [key, into] : wanted) {
    const rapidjson::Value* value = member(object, key);
    if (value == nullptr || !value->IsNumber()) return false;
    *into = value->GetDouble();
  }
  return true;
}

std::vector<double> list(const rapidjson::Value& object, const char* key) {
  std::vector<double> result;
  const rapidjson::Value* value = member(object, key);
  if (value == nullptr || !value->IsArray()) return result;
  for (const rapidjson::Value& item : value->GetArray()) {
    if (item.IsNumber()) result.push_back(item.GetDouble());
  }
  return result;
}

/// T_vehicle_camera
std::optional<Pose> pose_in_vehicle(const std::string& bytes) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str(), bytes.size());
  if (document.HasParseError()) return std::nullopt;
  const rapidjson::Value* extrinsic = member(document, "extrinsic");
  if (extrinsic == nullptr) return std::nullopt;
  std::vector<double> q = list(*extrinsic, "quaternion");
  const std::vector<double> t = list(*extrinsic, "translation");
  if (q.size() != 4 || t.size() != 3) return std::nullopt;
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& component : q) component /= length;
  const double x = q[0];
  const double y = q[1];
  const double z = q[2];
  const double w = q[3];
  return Pose{{{1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w), t[0]},
               {2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w), t[1]},
               {2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y), t[2]}}};
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str(), bytes.size());
  if (document.HasParseError() || index > 0) return std::nullopt;
  const rapidjson::Value* intrinsic = member(document, "intrinsic");
  if (intrinsic == nullptr) return std::nullopt;
  double width = 0.0;
  double height = 0.0;
  double aspect = 0.0;
  double cx_offset = 0.0;
  double cy_offset = 0.0;
  std::array<double, 4> k{};
  if (!read_numbers(*intrinsic, {{"width", &width},
                                 {"height", &height},
                                 {"aspect_ratio", &aspect},
                                 {"cx_offset", &cx_offset},
                                 {"cy_offset", &cy_offset},
                                 {"k1", &k[0]},
                                 {"k2", &k[1]},
                                 {"k3", &k[2]},
                                 {"k4", &k[3]}})) {
    return std::nullopt;
  }
  const Size size = {static_cast<int>(width), static_cast<int>(height)};
  const double cx = 0.5 * size.width + cx_offset - 0.5;
  const double cy = 0.5 * size.height + cy_offset - 0.5;
  PixelFormula formula;
  formula.size = size;
  formula.pixel = [k, cx, cy, aspect](const Ray& p) -> std::optional<Pixel> {
    const double chi = std::sqrt(p[0] * p[0] + p[1] * p[1]);
    if (chi == 0.0) return p[2] > 0.0 ? std::optional(Pixel{cx, cy}) : std::nullopt;
    const double theta = 0.5 * M_PI - std::atan2(p[2], chi);
    const double rho = k[0] * theta + k[1] * std::pow(theta, 2) + k[2] * std::pow(theta, 3) + k[3] * std::pow(theta, 4);
    return Pixel{rho / chi * p[0] + cx, aspect * (rho / chi * p[1]) + cy};
  };
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  if (files.size() < 2) return {};
  const std::optional<Pose> first = pose_in_vehicle(files[0]);
  const std::optional<Pose> second = pose_in_vehicle(files[1]);
  if (!first || !second) return {};
  return {inverse(*second) * *first};
}

}  // namespace fca::matrix::woodscape
