// SPDX-License-Identifier: BSD-3-Clause
// ROS's camera_info as sensor_msgs/CameraInfo.msg documents it and image_geometry computes with it: K and D of the image as it
// comes, by OpenCV's formulas (its documentation of calib3d and fisheye), of the region of interest and the binning that the
// file specifies. R rotates into the rectified frame; P(0, 3) = -fx x and P(1, 3) = -fy y of the camera's place in it.
//
// Behind the camera cv::projectPoints mirrors; there this formula has no pixel. cv::fisheye divides by z first and so ends at
// 90 deg; here the angle is taken instead: that limit is the program's own affair, the formula goes on.
#include "pixels_ros.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace fca::matrix::ros {

namespace {

/// The keys of an .ini in YAML's, as far as they are asked here: sections in brackets, a key in a line, its value in the next
/// ones.
std::string as_yaml(const std::string& bytes) {
  std::string yaml;
  std::istringstream stream(bytes);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) line.pop_back();
    if (!line.empty() && line.front() != '#' && line.front() != ';') lines.push_back(line);
  }
  if (lines.empty() || lines.front().front() != '[') return bytes;
  const auto list = [&lines](std::size_t first, std::size_t count) {
    std::string text;
    for (std::size_t i = first; i < std::min(first + count, lines.size()); ++i) text += lines[i] + " ";
    std::ranges::replace(text, ' ', ',');
    while (!text.empty() && text.back() == ',') text.pop_back();
    return "{data: [" + text + "]}\n";
  };
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (lines[i] == "width" || lines[i] == "height") yaml += "image_" + lines[i] + ": " + lines[i + 1] + "\n";
    if (lines[i] == "camera matrix") yaml += "camera_matrix: " + list(i + 1, 3);
    if (lines[i] == "distortion") yaml += "distortion_coefficients: " + list(i + 1, 1);
    if (lines[i] == "rectification") yaml += "rectification_matrix: " + list(i + 1, 3);
    if (lines[i] == "projection") yaml += "projection_matrix: " + list(i + 1, 3);
  }
  return yaml;
}

YAML::Node load(const std::string& bytes) { return YAML::Load(as_yaml(bytes)); }

std::vector<double> data(const YAML::Node& info, const char* key) {
  std::vector<double> result;
  for (const YAML::Node& number : info[key]["data"]) result.push_back(number.as<double>());
  return result;
}

int number(const YAML::Node& info, const char* key, int otherwise) { return info[key] ? info[key].as<int>() : otherwise; }

/// The ray of a plane at z = 1, turned about x and then about y, meets the plane that is turned with it.
Pixel on_turned_plane(const Pixel& m, double about_x, double about_y) {
  const double across = std::cos(about_x) * m[1] + std::sin(about_x);
  const double depth = std::cos(about_x) - std::sin(about_x) * m[1];
  const double right = std::cos(about_y) * m[0] - std::sin(about_y) * depth;
  const double ahead = std::sin(about_y) * m[0] + std::cos(about_y) * depth;
  const double away = std::cos(about_y) * std::cos(about_x);
  return {(away * right + std::sin(about_y) * std::cos(about_x) * ahead) / ahead,
          (away * across - std::sin(about_x) * ahead) / ahead};
}

/// x and y at z = 1.
Pixel plumb_bob(const std::vector<double>& d, double x, double y) {
  const auto k = [&d](std::size_t i) { return i < d.size() ? d[i] : 0.0; };
  const double r2 = x * x + y * y;
  const double up = 1.0 + k(0) * r2 + k(1) * std::pow(r2, 2) + k(4) * std::pow(r2, 3);
  const double down = 1.0 + k(5) * r2 + k(6) * std::pow(r2, 2) + k(7) * std::pow(r2, 3);
  const Pixel m = {x * up / down + 2.0 * k(2) * x * y + k(3) * (r2 + 2.0 * x * x) + k(8) * r2 + k(9) * r2 * r2,
                   y * up / down + k(2) * (r2 + 2.0 * y * y) + 2.0 * k(3) * x * y + k(10) * r2 + k(11) * r2 * r2};
  return on_turned_plane(m, k(12), k(13));
}

Pixel equidistant(const std::vector<double>& k, const Ray& ray) {
  const double r = std::hypot(ray[0], ray[1]);
  if (r == 0.0) return {0.0, 0.0};
  const double t = std::atan2(r, ray[2]);
  const double td = t + k[0] * std::pow(t, 3) + k[1] * std::pow(t, 5) + k[2] * std::pow(t, 7) + k[3] * std::pow(t, 9);
  return {td / r * ray[0], td / r * ray[1]};
}

std::optional<PixelFormula> formula_of(const YAML::Node& info) {
  const std::vector<double> K = data(info, "camera_matrix");
  const std::vector<double> D = data(info, "distortion_coefficients");
  const bool fisheye = info["distortion_model"] && info["distortion_model"].as<std::string>() == "equidistant";
  if (K.size() != 9 || (fisheye && D.size() != 4)) return std::nullopt;
  const YAML::Node roi = info["roi"];
  const double left = roi ? number(roi, "x_offset", 0) : 0;
  const double top = roi ? number(roi, "y_offset", 0) : 0;
  const int across = std::max(number(info, "binning_x", 1), 1);
  const int down = std::max(number(info, "binning_y", 1), 1);
  Size size = {info["image_width"].as<int>(), info["image_height"].as<int>()};
  if (roi && number(roi, "width", 0) > 0) size = {number(roi, "width", 0), number(roi, "height", 0)};
  PixelFormula formula;
  formula.size = Size{size.width / across, size.height / down};
  formula.pixel = [=](const Ray& ray) -> std::optional<Pixel> {
    if (!fisheye && !(ray[2] > 0.0)) return std::nullopt;
    const Pixel p = fisheye ? equidistant(D, ray) : plumb_bob(D, ray[0] / ray[2], ray[1] / ray[2]);
    return Pixel{(K[0] * p[0] + K[2] - left) / across, (K[4] * p[1] + K[5] - top) / down};
  };
  return formula;
}

/// T_rectified_camera
std::optional<Pose> place(const std::string& bytes) {
  const YAML::Node info = load(bytes);
  if (!info["rectification_matrix"] || !info["projection_matrix"]) return std::nullopt;
  const std::vector<double> R = data(info, "rectification_matrix");
  const std::vector<double> P = data(info, "projection_matrix");
  if (R.size() != 9 || P.size() != 12) return std::nullopt;
  return Pose{{{R[0], R[1], R[2], -P[3] / P[0]}, {R[3], R[4], R[5], -P[7] / P[5]}, {R[6], R[7], R[8], 0.0}}};
}

/// Do the files speak of one rectified image?
bool is_pair(const std::string& a, const std::string& b) {
  const std::vector<double> P = data(load(a), "projection_matrix");
  const std::vector<double> Q = data(load(b), "projection_matrix");
  const bool same = P.size() == 12 && Q.size() == 12 && P[0] == Q[0] && P[5] == Q[5] && P[6] == Q[6];
  return same && (P[3] != Q[3] || P[7] != Q[7]);
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  if (index > 0) return std::nullopt;
  try {
    return formula_of(load(bytes));
  } catch (const YAML::Exception&) {
    return std::nullopt;
  }
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  if (files.size() < 2) return {};
  try {
    if (!is_pair(files[0], files[1])) return {};
    const std::optional<Pose> first = place(files[0]);
    const std::optional<Pose> second = place(files[1]);
    if (!first || !second) return {};
    return {inverse(*second) * *first};
  } catch (const YAML::Exception&) {
    return {};
  }
}

}  // namespace fca::matrix::ros
