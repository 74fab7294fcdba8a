// SPDX-License-Identifier: BSD-3-Clause
// Basalt's calibration JSON as basalt-headers computes with it (MORE-FORMATS.md section 6). ucm, eucm and ds after Usenko,
// Demmel, Cremers 2018, "The Double Sphere Camera Model", equations 12, 24 and 40, with their half spaces; fov after Devernay
// and Faugeras 2001. T_imu_cam: camera to IMU, quaternion x y z w.
#include "pixels_basalt.h"

#include <rapidjson/document.h>

#include <map>

namespace fca::matrix::basalt {

namespace {

using Values = std::map<std::string, double>;

rapidjson::Document parsed(const std::string& bytes) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str(), bytes.size());
  return document;
}

/// The item of value0's list; null if there is none.
const rapidjson::Value* item(const rapidjson::Document& document, const char* key, std::size_t index) {
  if (document.HasParseError() || !document.IsObject() || !document.HasMember("value0")) return nullptr;
  const rapidjson::Value& value = document["value0"];
  if (!value.HasMember(key) || !value[key].IsArray() || index >= value[key].Size()) return nullptr;
  return &value[key][static_cast<rapidjson::SizeType>(index)];
}

Values numbers(const rapidjson::Value& object) {
  Values values;
  for (const auto& member : object.GetObject()) {
    if (member.value.IsNumber()) values[member.name.GetString()] = member.value.GetDouble();
  }
  return values;
}

/// On the image plane of focal length 1; nothing where there is no image.
std::optional<Pixel> on_plane(const std::string& type, Values p, double x, double y, double z) {
  const double r = std::hypot(x, y);
  const double d = std::sqrt(r * r + z * z);
  if (type == "pinhole") return z > 0.0 ? std::optional(Pixel{x / z, y / z}) : std::nullopt;
  if (type == "kb4") {
    if (r == 0.0) return z > 0.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
    const double t = std::atan2(r, z);
    const double radius =
        t + p["k1"] * std::pow(t, 3) + p["k2"] * std::pow(t, 5) + p["k3"] * std::pow(t, 7) + p["k4"] * std::pow(t, 9);
    return Pixel{radius * x / r, radius * y / r};
  }
  if (type == "fov") {
    if (r == 0.0) return z > 0.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
    const double radius = std::atan2(2.0 * r * std::tan(0.5 * p["w"]), z) / p["w"];
    return Pixel{radius * x / r, radius * y / r};
  }
  if (type == "pinhole-radtan8") {
    if (!(z > 0.0)) return std::nullopt;
    const double a = x / z;
    const double b = y / z;
    const double s = a * a + b * b;
    if (p["rpmax"] > 0.0 && std::sqrt(s) > p["rpmax"]) return std::nullopt;
    const double c = (1.0 + p["k1"] * s + p["k2"] * s * s + p["k3"] * s * s * s) /
                     (1.0 + p["k4"] * s + p["k5"] * s * s + p["k6"] * s * s * s);
    return Pixel{a * c + 2.0 * p["p1"] * a * b + p["p2"] * (s + 2.0 * a * a),
                 b * c + p["p1"] * (s + 2.0 * b * b) + 2.0 * p["p2"] * a * b};
  }
  const double alpha = p["alpha"];
  const double w = alpha <= 0.5 ? alpha / (1.0 - alpha) : (1.0 - alpha) / alpha;
  double denominator = 0.0;
  if (type == "ucm") {
    if (z <= -w * d) return std::nullopt;
    denominator = alpha * d + (1.0 - alpha) * z;
  } else if (type == "eucm") {
    const double e = std::sqrt(p["beta"] * r * r + z * z);
    if (z <= -w * e) return std::nullopt;
    denominator = alpha * e + (1.0 - alpha) * z;
  } else if (type == "ds") {
    const double xi = p["xi"];
    if (z <= -(w + xi) / std::sqrt(2.0 * w * xi + xi * xi + 1.0) * d) return std::nullopt;
    const double shifted = xi * d + z;
    denominator = alpha * std::sqrt(r * r + shifted * shifted) + (1.0 - alpha) * shifted;
  } else {
    return std::nullopt;
  }
  return Pixel{x / denominator, y / denominator};
}

/// T_imu_cam
std::optional<Pose> pose_in_imu(const rapidjson::Document& document, std::size_t index) {
  const rapidjson::Value* stated = item(document, "T_imu_cam", index);
  if (stated == nullptr || !stated->IsObject()) return std::nullopt;
  Values v = numbers(*stated);
  // The columns are the images of the axes: q e q*.
  Pose pose{};
  const std::array<double, 4> q = {v["qx"], v["qy"], v["qz"], v["qw"]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t b = (axis + 1) % 3;
    const std::size_t c = (axis + 2) % 3;
    pose[axis][axis] = q[3] * q[3] + q[axis] * q[axis] - q[b] * q[b] - q[c] * q[c];
    pose[b][axis] = 2.0 * (q[axis] * q[b] + q[3] * q[c]);
    pose[c][axis] = 2.0 * (q[axis] * q[c] - q[3] * q[b]);
  }
  pose[0][3] = v["px"];
  pose[1][3] = v["py"];
  pose[2][3] = v["pz"];
  return pose;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const rapidjson::Document document = parsed(bytes);
  const rapidjson::Value* lens = item(document, "intrinsics", index);
  const rapidjson::Value* size = item(document, "resolution", index);
  if (lens == nullptr || !lens->IsObject() || !lens->HasMember("camera_type") || !lens->HasMember("intrinsics"))
    return std::nullopt;
  const std::string type = (*lens)["camera_type"].GetString();
  const Values p = numbers((*lens)["intrinsics"]);
  PixelFormula formula;
  if (size != nullptr) formula.size = Size{(*size)[0].GetInt(), (*size)[1].GetInt()};
  formula.pixel = [type, p](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> m = on_plane(type, p, ray[0], ray[1], ray[2]);
    if (!m) return std::nullopt;
    return Pixel{p.at("fx") * (*m)[0] + p.at("cx"), p.at("fy") * (*m)[1] + p.at("cy")};
  };
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  if (files.empty()) return {};
  const rapidjson::Document document = parsed(files.front());
  const std::optional<Pose> first = pose_in_imu(document, 0);
  const std::optional<Pose> second = pose_in_imu(document, 1);
  if (!first || !second) return {};
  return {inverse(*second) * *first};
}

}  // namespace fca::matrix::basalt
