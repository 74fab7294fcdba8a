// SPDX-License-Identifier: BSD-3-Clause
// A ZED's SN*.conf with one size of images, as zed-opencv-native reads it and Stereolabs' tool writes it (MORE-FORMATS-2.md
// section 20.3): OpenCV's coefficients, k1 to k4 alone its fisheye's; T_right_left from a rotation vector and millimetres.
#include "pixels_zed.h"

#include "opencv_lens.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace fca::matrix::zed {

namespace {

using Values = std::map<std::string, double>;

/// By section and key, in upper case.
std::map<std::string, Values> sections_of(const std::string& bytes) {
  std::map<std::string, Values> sections;
  std::istringstream stream(bytes);
  std::string section;
  for (std::string line; std::getline(stream, line);) {
    std::ranges::transform(line, line.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const std::size_t equals = line.find('=');
    if (line.starts_with('[')) section = line.substr(1, line.find(']') - 1);
    if (equals == std::string::npos || line.starts_with('[')) continue;
    std::string key = line.substr(0, equals);
    std::erase(key, ' ');
    sections[section][key] = std::stod(line.substr(equals + 1));
  }
  return sections;
}

std::optional<std::pair<std::string, Values>> camera_section(const std::map<std::string, Values>& sections,
                                                             const std::string& side) {
  for (const auto& [name, values] : sections) {
    if (name.starts_with(side + "_CAM_")) return std::pair(name.substr(side.size() + 5), values);
  }
  return std::nullopt;
}

std::optional<PixelFormula> camera_of(const std::map<std::string, Values>& sections, const std::string& side) {
  static const std::map<std::string, Size> sizes = {{"2K", {2208, 1242}}, {"FHD", {1920, 1080}}, {"HD", {1280, 720}},
                                                    {"VGA", {672, 376}},  {"SVGA", {960, 600}},  {"FHD1200", {1920, 1200}},
                                                    {"4K", {3840, 2160}}};
  const auto found = camera_section(sections, side);
  if (!found) return std::nullopt;
  Values K = found->second;
  const auto disto = sections.find(side + "_DISTO");
  Values D = disto == sections.end() ? K : disto->second;
  const RayToPixel lens = D.contains("P1") ? pinhole({D["K1"], D["K2"], D["P1"], D["P2"], D["K3"], D["K4"], D["K5"], D["K6"]})
                                           : fisheye({D["K1"], D["K2"], D["K3"], D["K4"]});
  PixelFormula formula;
  formula.pixel = in_image(lens, K["FX"], K["FY"], K["CX"], K["CY"]);
  formula.size = sizes.at(found->first);
  return formula;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const std::map<std::string, Values> sections = sections_of(bytes);
  if (index > 1) return std::nullopt;
  return camera_of(sections, index == 0 ? "LEFT" : "RIGHT");
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  std::map<std::string, Values> sections = sections_of(files.front());
  const auto right = camera_section(sections, "RIGHT");
  if (!right) return {};
  Values& stereo = sections["STEREO"];
  const std::array<double, 3> v = {stereo["RX_" + right->first], stereo["CV_" + right->first], stereo["RZ_" + right->first]};
  // Rodrigues' formula, I + sin(a) / a [v] + (1 - cos(a)) / a^2 [v]^2.
  const double a = std::hypot(v[0], v[1], v[2]);
  const double s = a > 0.0 ? std::sin(a) / a : 1.0;
  const double c = a > 0.0 ? (1.0 - std::cos(a)) / (a * a) : 0.5;
  const double cross[3][3] = {{0.0, -v[2], v[1]}, {v[2], 0.0, -v[0]}, {-v[1], v[0], 0.0}};
  Pose pose = identity_pose();
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      pose[row][column] += s * cross[row][column];
      for (std::size_t k = 0; k < 3; ++k) pose[row][column] += c * cross[row][k] * cross[k][column];
    }
  }
  pose[0][3] = -stereo["BASELINE"] / 1000.0;
  pose[1][3] = stereo["TY"] / 1000.0;
  pose[2][3] = stereo["TZ"] / 1000.0;
  return {pose};
}

}  // namespace fca::matrix::zed
