// SPDX-License-Identifier: BSD-3-Clause
// Settings as ORB-SLAM3 and its relatives compute with them. Source of keys and dialects: FORMATS.md section 3
// (UZ-SLAMLab/ORB_SLAM3 V1.0: Settings.cc, CameraModels/Pinhole.cpp, KannalaBrandt8.cpp; raulmur/ORB_SLAM2;
// ns15417/slam_no_opt: EUCM with alpha, beta under k1, k2 and KB with k1..k4 under k1 k2 p1 p2; urbste/ORB_SLAM3:
// DoubleSphere). Images are those of Camera.width x height, before the program's own rescaling. KannalaBrandt8: Kannala and
// Brandt 2006, theta (1 + k1 theta^2 + ...), with atan2.
#include "pixels_orbslam3.h"

#include "storage.h"

namespace fca::matrix::orbslam3 {

namespace {

using Lens = std::function<std::optional<Pixel>(const Ray&)>;

Lens kannala_brandt(const std::array<double, 4>& k) {
  return [k](const Ray& p) -> std::optional<Pixel> {
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1]);
    const double theta = std::atan2(r, p[2]);
    if (r == 0.0) return theta < 1.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
    const double theta3 = theta * theta * theta;
    const double theta5 = theta3 * theta * theta;
    const double theta7 = theta5 * theta * theta;
    const double theta9 = theta7 * theta * theta;
    const double d = theta + k[0] * theta3 + k[1] * theta5 + k[2] * theta7 + k[3] * theta9;
    return Pixel{d * (p[0] / r), d * (p[1] / r)};
  };
}

/// k1 k2 p1 p2 k3 as OpenCV's undistortPoints takes them.
Lens pinhole(const std::array<double, 5>& d) {
  return [d](const Ray& p) -> std::optional<Pixel> {
    if (p[2] <= 0.0) return std::nullopt;
    const double x = p[0] / p[2];
    const double y = p[1] / p[2];
    const double rr = x * x + y * y;
    const double radial = 1.0 + d[0] * rr + d[1] * rr * rr + d[4] * rr * rr * rr;
    return Pixel{x * radial + 2.0 * d[2] * x * y + d[3] * (rr + 2.0 * x * x),
                 y * radial + d[2] * (rr + 2.0 * y * y) + 2.0 * d[3] * x * y};
  };
}

Lens extended_unified(double alpha, double beta) {
  return [alpha, beta](const Ray& p) -> std::optional<Pixel> {
    const double rho = std::sqrt(p[2] * p[2] + beta * (p[0] * p[0] + p[1] * p[1]));
    const double below = p[2] + alpha * (rho - p[2]);
    if (below <= 0.0) return std::nullopt;
    return Pixel{p[0] / below, p[1] / below};
  };
}

Lens double_sphere(double xi, double alpha) {
  return [xi, alpha](const Ray& p) -> std::optional<Pixel> {
    const double rr = p[0] * p[0] + p[1] * p[1];
    const double shifted = xi * std::sqrt(rr + p[2] * p[2]) + p[2];
    const double below = alpha * std::sqrt(rr + shifted * shifted) + (1.0 - alpha) * shifted;
    if (below <= 0.0) return std::nullopt;
    return Pixel{p[0] / below, p[1] / below};
  };
}

PixelFormula formula_of(const Lens& lens, double fx, double fy, double cx, double cy, const cv::FileStorage& settings) {
  PixelFormula formula;
  formula.pixel = [lens, fx, fy, cx, cy](const Ray& p) -> std::optional<Pixel> {
    const std::optional<Pixel> m = lens(p);
    if (!m) return std::nullopt;
    return Pixel{fx * (*m)[0] + cx, fy * (*m)[1] + cy};
  };
  const int width = static_cast<int>(number(settings["Camera.width"]));
  const int height = static_cast<int>(number(settings["Camera.height"]));
  if (width > 0 && height > 0) formula.size = Size{width, height};
  return formula;
}

bool has_intrinsics(const cv::FileStorage& settings, const std::string& owner) {
  for (const char* key : {"fx", "fy", "cx", "cy"}) {
    if (!is_number(settings[owner + "." + key])) return false;
  }
  return true;
}

/// slam_no_opt's right camera: RIGHT.K and RIGHT.D, in the order of the five keys.
std::optional<PixelFormula> right_camera(const cv::FileStorage& settings, const std::string& type) {
  const std::vector<double> K = numbers(settings["RIGHT.K"]);
  const std::vector<double> D = numbers(settings["RIGHT.D"]);
  if (K.size() != 9 || D.size() < 4) return std::nullopt;
  const Lens lens = type == "EUCM" ? extended_unified(D[0], D[1]) : kannala_brandt({D[0], D[1], D[2], D[3]});
  return formula_of(lens, K[0], K[4], K[2], K[5], settings);
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const cv::FileStorage settings = open_storage(bytes);
  if (!settings.isOpened() || index > 1) return std::nullopt;
  const cv::FileNode version = settings["File.version"];
  const bool new_style = version.isString() && static_cast<std::string>(version) == "1.0";
  std::string type = static_cast<std::string>(settings["Camera.type"]);
  type = type.substr(0, type.find_first_of(" \t#"));  // OpenCV takes a comment into a bare word (FORMATS.md section 0)
  const bool fork = type == "EUCM" || type == "KB";
  if (fork && index == 1) return right_camera(settings, type);

  std::string owner = "Camera";
  if (new_style) owner = index == 0 ? "Camera1" : "Camera2";
  if (!new_style && index == 1) owner = "Camera2";
  if (!has_intrinsics(settings, owner)) return std::nullopt;
  const auto value = [&](const char* key) { return number(settings[owner + "." + key]); };
  const auto with = [&](const Lens& lens) {
    return formula_of(lens, value("fx"), value("fy"), value("cx"), value("cy"), settings);
  };
  if (type == "KannalaBrandt8") return with(kannala_brandt({value("k1"), value("k2"), value("k3"), value("k4")}));
  if (type == "KB") return with(kannala_brandt({value("k1"), value("k2"), value("p1"), value("p2")}));
  if (type == "EUCM") return with(extended_unified(value("k1"), value("k2")));
  if (type == "DoubleSphere") return with(double_sphere(value("xi"), value("alpha")));
  if (type == "Rectified") return with(pinhole({0.0, 0.0, 0.0, 0.0, 0.0}));
  if (type == "PinHole" || (type.empty() && !new_style)) {
    return with(pinhole({value("k1"), value("k2"), value("p1"), value("p2"), value("k3")}));
  }
  return std::nullopt;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  std::vector<Pose> result;
  for (const std::string& bytes : files) {
    const cv::FileStorage settings = open_storage(bytes);
    if (!settings.isOpened()) continue;
    // p_c1 = T p_c2 and p_left = Tlr p_right
    for (const char* key : {"Stereo.T_c1_c2", "Tlr"}) {
      if (const std::optional<Pose> pose = pose_of(numbers(settings[key]))) result.push_back(inverse(*pose));
    }
    // slam_no_opt: p_right = R p_left + T
    const std::vector<double> R = numbers(settings["CAMERA.R"]);
    const std::vector<double> T = numbers(settings["CAMERA.T"]);
    if (R.size() == 9 && T.size() == 3) {
      result.push_back({{{R[0], R[1], R[2], T[0]}, {R[3], R[4], R[5], T[1]}, {R[6], R[7], R[8], T[2]}}});
    }
  }
  return result;
}

}  // namespace fca::matrix::orbslam3
