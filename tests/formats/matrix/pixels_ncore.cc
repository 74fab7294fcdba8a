// SPDX-License-Identifier: BSD-3-Clause
// NCore's cameras with OpenCV's lenses by its data/types.py (NVIDIA/ncore@77144a9): pixels count from the image's corner, and
// T_sensor_rig is where the camera is in the vehicle.
#include "pixels_ncore.h"

#include "opencv_lens.h"

#include <cmath>

#include <rapidjson/document.h>

namespace fca::matrix::ncore {

namespace {

std::vector<double> numbers_of(const rapidjson::Value& list) {
  std::vector<double> numbers;
  for (const rapidjson::Value& number : list.GetArray()) numbers.push_back(number.GetDouble());
  return numbers;
}

/// From the angle to the distance, sheared, about a centre that counts from the middle of the first pixel.
RayToPixel ftheta(const std::vector<double>& polynomial, const std::vector<double>& cde, const std::vector<double>& centre) {
  return [polynomial, cde, centre](const Ray& ray) -> std::optional<Pixel> {
    const double sine = std::hypot(ray[0], ray[1]);
    const double theta = std::atan2(sine, ray[2]);
    double distance = 0.0;
    for (std::size_t i = 0; i < polynomial.size(); ++i) distance += polynomial[i] * std::pow(theta, static_cast<double>(i));
    const double x = sine > 0.0 ? distance * ray[0] / sine : 0.0;
    const double y = sine > 0.0 ? distance * ray[1] / sine : 0.0;
    return Pixel{centre[0] + cde[0] * x + cde[1] * y, centre[1] + cde[2] * x + y};
  };
}

Pose pose_of(const rapidjson::Value& camera) {
  Pose pose{};
  for (std::size_t row = 0; row < 3; ++row) {
    const std::vector<double> numbers = numbers_of(camera["T_sensor_rig"][static_cast<rapidjson::SizeType>(row)]);
    for (std::size_t column = 0; column < 4; ++column) pose[row][column] = numbers[column];
  }
  return pose;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str(), bytes.size());
  if (document.HasParseError() || index >= document.MemberCount()) return std::nullopt;
  const rapidjson::Value& entry = (document.MemberBegin() + static_cast<std::ptrdiff_t>(index))->value;
  const rapidjson::Value& in = entry["intrinsics"];
  PixelFormula formula;
  formula.size = Size{entry["resolution"][0].GetInt(), entry["resolution"][1].GetInt()};
  const std::vector<double> c = numbers_of(in["principal_point"]);
  if (std::string(entry["camera_model_type"].GetString()) == "ftheta") {
    formula.pixel = ftheta(numbers_of(in["angle_to_pixeldist_poly"]), numbers_of(in["linear_cde"]), c);
    return formula;
  }
  const std::vector<double> k = numbers_of(in["radial_coeffs"]);
  RayToPixel lens;
  if (std::string(entry["camera_model_type"].GetString()) == "opencv-fisheye") {
    lens = fisheye(k);
  } else {
    const std::vector<double> p = numbers_of(in["tangential_coeffs"]);
    const std::vector<double> s = numbers_of(in["thin_prism_coeffs"]);
    lens = pinhole({k[0], k[1], p[0], p[1], k[2], k[3], k[4], k[5], s[0], s[1], s[2], s[3]});
  }
  const std::vector<double> f = numbers_of(in["focal_length"]);
  formula.pixel = in_image(lens, f[0], f[1], c[0] - 0.5, c[1] - 0.5);
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(files.front().c_str(), files.front().size());
  if (document.HasParseError() || document.MemberCount() < 2) return {};
  return {inverse(pose_of((document.MemberBegin() + 1)->value)) * pose_of(document.MemberBegin()->value)};
}

}  // namespace fca::matrix::ncore
