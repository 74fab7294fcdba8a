// SPDX-License-Identifier: BSD-3-Clause
// mrcal's .cameramodel (MORE-FORMATS.md section 12): the list after a key in quotes, in OpenCV's formulas with k1 k2 p1 p2 k3
// k4 k5 k6 s1 s2 s3 s4. Poses are rotation vector and translation of the reference in the camera.
#include "pixels_mrcal.h"

#include "sensor_lens.h"

#include <cstdlib>

namespace fca::matrix::mrcal {

namespace {

/// Where the value of a key begins; npos where there is none. Keys in comments are none.
std::size_t value_at(const std::string& bytes, const std::string& key) {
  for (const char quote : {'\'', '"'}) {
    const std::string quoted = quote + key + quote;
    for (std::size_t at = bytes.find(quoted); at != std::string::npos; at = bytes.find(quoted, at + 1)) {
      const std::size_t line = bytes.rfind('\n', at);
      const std::string before = bytes.substr(line + 1, at - line - 1);
      const std::size_t colon = bytes.find_first_not_of(" \t", at + quoted.size());
      if (before.find('#') == std::string::npos && colon != std::string::npos && bytes[colon] == ':')
        return bytes.find_first_not_of(" \t\r\n", colon + 1);
    }
  }
  return std::string::npos;
}

std::vector<double> numbers(const std::string& bytes, const std::string& key) {
  std::vector<double> values;
  const std::size_t at = value_at(bytes, key);
  if (at == std::string::npos || (bytes[at] != '[' && bytes[at] != '(')) return values;
  const char* text = bytes.c_str() + at + 1;
  while (true) {
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    if (end == text) return values;
    values.push_back(value);
    text = end;
    while (*text == ' ' || *text == '\t' || *text == '\r' || *text == '\n') ++text;
    if (*text != ',') return values;
    ++text;
  }
}

std::string word(const std::string& bytes, const std::string& key) {
  const std::size_t at = value_at(bytes, key);
  if (at == std::string::npos) return "";
  return bytes.substr(at + 1, bytes.find(bytes[at], at + 1) - at - 1);
}

/// T_reference_camera: the inverse of what is specified.
std::optional<Pose> pose_in_reference(const std::string& bytes) {
  std::vector<double> rt = numbers(bytes, "rt_cam_ref");
  if (rt.empty()) rt = numbers(bytes, "extrinsics");
  if (rt.size() != 6) return std::nullopt;
  // R = I + sin(a) / a K + (1 - cos(a)) / a^2 K^2, K the cross product with r.
  const double a2 = rt[0] * rt[0] + rt[1] * rt[1] + rt[2] * rt[2];
  const double a = std::sqrt(a2);
  const double first = a > 0.0 ? std::sin(a) / a : 1.0;
  const double second = a > 0.0 ? 2.0 * std::pow(std::sin(0.5 * a) / a, 2) : 0.5;
  const double K[3][3] = {{0.0, -rt[2], rt[1]}, {rt[2], 0.0, -rt[0]}, {-rt[1], rt[0], 0.0}};
  Pose pose = identity_pose();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      pose[i][j] += first * K[i][j];
      for (std::size_t k = 0; k < 3; ++k) pose[i][j] += second * K[i][k] * K[k][j];
    }
    pose[i][3] = rt[3 + i];
  }
  return inverse(pose);
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const std::vector<double> values = numbers(bytes, "intrinsics");
  const std::vector<double> size = numbers(bytes, "imagersize");
  const std::string lens = word(bytes, "lensmodel") + word(bytes, "lens_model") + word(bytes, "distortion_model");
  if (index > 0 || size.size() != 2 || values.size() < 4) return std::nullopt;
  const std::size_t opencv = lens.rfind("OPENCV");
  const std::size_t count = opencv == std::string::npos ? 0 : static_cast<std::size_t>(std::stoi(lens.substr(opencv + 6)));
  if ((count == 0 && !lens.ends_with("_PINHOLE")) || values.size() != 4 + count) return std::nullopt;
  std::vector<double> d(values.begin() + 4, values.end());
  d.resize(12, 0.0);
  const std::vector<double> k(values.begin(), values.begin() + 4);
  const RayToPixel without_prism = sensor_lens(k, std::vector<double>(d.begin(), d.begin() + 8), false);
  PixelFormula formula;
  formula.size = Size{static_cast<int>(size[0]), static_cast<int>(size[1])};
  formula.pixel = [without_prism, k, d](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> pixel = without_prism(ray);
    if (!pixel) return pixel;
    const double s = (ray[0] * ray[0] + ray[1] * ray[1]) / (ray[2] * ray[2]);
    return Pixel{(*pixel)[0] + k[0] * (d[8] * s + d[9] * s * s), (*pixel)[1] + k[1] * (d[10] * s + d[11] * s * s)};
  };
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) { return second_in_first(files, &pose_in_reference); }

}  // namespace fca::matrix::mrcal
