// SPDX-License-Identifier: BSD-3-Clause
// ORB-SLAM2 (raulmur/ORB_SLAM2@f2e6f51, src/Tracking.cc) and ns15417/slam_no_opt (src/Tracking.cc, src/SystemSetting.cc,
// src/CameraModels), which reads EUCM and KB from ORB-SLAM2's keys. Both convert implicitly and take 0 for a missing key.
#include <algorithm>
#include <cmath>

#include "orbslam_shared.h"
#include "programs.h"

namespace fca::consumers {
namespace orbslam {
namespace {

void warn_missing(Settings& settings, std::string_view key) {
  if (!settings.has(key)) settings.warn_at(key, Code::kOrbslamTakesZero, {settings.program()});
}

Intrinsics read_intrinsics(Settings& settings) {
  for (const std::string_view key : {"Camera.fx", "Camera.fy", "Camera.cx", "Camera.cy"}) warn_missing(settings, key);
  return {settings.loose("Camera.fx"), settings.loose("Camera.fy"), settings.loose("Camera.cx"), settings.loose("Camera.cy")};
}

/// ORBextractor writes to element 0 of arrays of this length.
void check_levels(Settings& settings) {
  constexpr std::string_view kLevels = "ORBextractor.nLevels";
  if (settings.loose(kLevels) >= 1.0F) return;
  settings.refuse_at(kLevels, Code::kOrbslamNoLevels, {settings.program()});
}

int read_size(Settings& settings, std::string_view key) {
  const float size = settings.loose(key);
  return size >= 0.0F && size < 1e6F ? static_cast<int>(size) : 0;
}

void refuse_imu(Settings& settings, const Sensor& sensor) {
  if (sensor.inertial) settings.refuse(Code::kOrbslamNotInertial, {settings.program()});
}

void warn_about_depth(Settings& settings, const Sensor& sensor) {
  if (!sensor.stereo && !sensor.rgbd) return;
  if (!settings.has("Camera.bf")) settings.refuse_at("Camera.bf", Code::kOrbslamNoBaseline, {settings.program()});
  warn_missing(settings, "ThDepth");
}

void load_orbslam2_settings(Settings& settings, const Sensor& sensor, ConsumerView& view) {
  refuse_imu(settings, sensor);
  const Intrinsics k = read_intrinsics(settings);
  if (k.fx == 0.0F) settings.refuse_at("Camera.fx", Code::kOrbslamNoFocalLength);
  const cv::FileNode type = settings.node("Camera.type");
  const bool other_model = !type.empty() && !(type.isString() && type.string() == "PinHole");
  if (other_model) settings.warn_at("Camera.type", Code::kOrbslamTypeNotRead, {description_of(type)});
  PinholeDistortion distortion = {settings.loose("Camera.k1"), settings.loose("Camera.k2"), settings.loose("Camera.p1"),
                                  settings.loose("Camera.p2"), settings.loose("Camera.k3")};
  const bool bent = std::any_of(distortion.begin(), distortion.end(), [](float value) { return value != 0.0F; });
  if (distortion.front() == 0.0F) {  // Frame::UndistortKeyPoints returns at once
    if (bent) settings.warn_at("Camera.k1", Code::kOrbslam2SkipsUndistortion);
    distortion = {};
  }
  check_levels(settings);
  warn_about_depth(settings, sensor);
  const int width = read_size(settings, "Camera.width");
  const int height = read_size(settings, "Camera.height");
  view.cameras.push_back({"cam0", width, height, pinhole(k, distortion), {1.0, 1.0}, other_model});
  view.cameras.back().model = "PinHole";
  if (!sensor.stereo) return;
  view.cameras.push_back(view.cameras.front());  // the images are taken as rectified
  view.cameras.back().name = "cam1";
  if (k.fx != 0.0F) view.poses.push_back(rectified_baseline(settings.loose("Camera.bf") / k.fx));
}

// --- ns15417/slam_no_opt
// ------------------------------------------------------------------------------------------------------

using FourFloats = std::array<float, 4>;

Projection make_camera(Settings& settings, const std::string& type, const Intrinsics& k, const FourFloats& d,
                       std::string_view where) {
  if (type == "KB") return kannala_brandt8(k, d);
  const auto& [alpha, beta, unused_3, unused_4] = d;
  if (alpha < 0.5F) settings.warn_at(where, Code::kOrbslamEucmRefusesAll, {alpha});
  return eucm(k, alpha, beta);
}

/// A matrix of numbers of any depth as floats, or nothing with a refusal if it is smaller than the program believes.
std::optional<cv::Mat> float_matrix(Settings& settings, std::string_view key, int rows, int cols) {
  std::optional<cv::Mat> matrix = settings.matrix(key);
  if (!matrix) return std::nullopt;
  const bool fits = matrix->dims == 2 && matrix->channels() == 1 &&
                    (rows == 1 ? std::min(matrix->rows, matrix->cols) == 1 && std::max(matrix->rows, matrix->cols) >= cols
                               : matrix->rows >= rows && matrix->cols >= cols);
  if (!fits) {
    settings.refuse_at(key, Code::kOrbslamSmallMatrix, {matrix->rows, matrix->cols, settings.program(), rows, cols});
    return std::nullopt;
  }
  cv::Mat converted;
  matrix->convertTo(converted, CV_32F);
  return converted;
}

/// RIGHT.K, RIGHT.D, and CAMERA.R, CAMERA.T with p_right = R p_left + T.
void read_right_camera(Settings& settings, const std::string& type, int width, int height, ConsumerView& view) {
  const auto k = float_matrix(settings, "RIGHT.K", 3, 3);
  const auto d = float_matrix(settings, "RIGHT.D", 1, 4);
  const auto r = float_matrix(settings, "CAMERA.R", 3, 3);
  const auto t = float_matrix(settings, "CAMERA.T", 1, 3);
  if (!k || !d || !r || !t) return;
  const Intrinsics intrinsics = {k->at<float>(0, 0), k->at<float>(1, 1), k->at<float>(0, 2), k->at<float>(1, 2)};
  FourFloats coeffs{};
  for (int i = 0; i < 4; ++i) coeffs.at(static_cast<std::size_t>(i)) = d->at<float>(i);
  view.cameras.push_back({"cam1", width, height, make_camera(settings, type, intrinsics, coeffs, "RIGHT.D")});
  view.cameras.back().model = type;
  ConsumerPose pose{"cam1", "cam0", {}};
  for (int row = 0; row < 3; ++row) {
    const auto base = static_cast<std::size_t>(4 * row);
    for (int col = 0; col < 3; ++col) pose.T_a_b.at(base + static_cast<std::size_t>(col)) = r->at<float>(row, col);
    pose.T_a_b.at(base + 3) = t->at<float>(row);
  }
  pose.T_a_b.back() = 1.0;
  view.poses.push_back(pose);
}

/// The program cuts the matrix up without looking, so a missing one ends it. It is camera -> the robot's base link.
void read_tbc(Settings& settings, ConsumerView& view) {
  const auto matrix = float_matrix(settings, "Camera.Tbc", 4, 4);
  if (!matrix) return;
  ConsumerPose pose{"imu0", "cam0", {}};
  for (int i = 0; i < 16; ++i) pose.T_a_b.at(static_cast<std::size_t>(i)) = matrix->at<float>(i / 4, i % 4);
  view.poses.push_back(pose);
}

void load_slam_no_opt_settings(Settings& settings, const Sensor& sensor, ConsumerView& view) {
  refuse_imu(settings, sensor);
  const cv::FileNode node = settings.node("Camera.type");
  const std::string type = node.isString() ? node.string() : std::string();
  if (type != "EUCM" && type != "KB") {
    if (node.empty()) {
      settings.refuse_at("Camera.type", Code::kOrbslamNoOptTypeMissing);
    } else {
      settings.refuse_at("Camera.type", Code::kOrbslamNoOptType, {description_of(node)});
    }
    return;
  }
  const Intrinsics k = read_intrinsics(settings);
  for (const std::string_view key : {"Camera.k1", "Camera.k2"}) warn_missing(settings, key);
  const bool kb = type == "KB";
  const FourFloats coeffs = {settings.loose("Camera.k1"), settings.loose("Camera.k2"),
                             settings.loose(kb ? "Camera.p1" : "Camera.k3"), settings.loose(kb ? "Camera.p2" : "Camera.k4")};
  if (kb && settings.has("Camera.k3")) settings.warn_at("Camera.k3", Code::kOrbslamNoOptK3Ignored);
  check_levels(settings);
  warn_about_depth(settings, sensor);
  const int width = read_size(settings, "Camera.width");
  const int height = read_size(settings, "Camera.height");
  view.cameras.push_back({"cam0", width, height, make_camera(settings, type, k, coeffs, "Camera.k1")});
  view.cameras.back().model = type;
  // t_image = t_imu + delay, as the program's own files say.
  const cv::FileNode delay = settings.node("Camera.delaytoimu");
  if (storage::is_number(delay)) view.cameras.back().time_offset_s = -static_cast<double>(delay);
  if (sensor.stereo) read_right_camera(settings, type, width, height, view);
  read_tbc(settings, view);
}

}  // namespace
}  // namespace orbslam

ConsumerView load_orbslam2(std::string_view bytes, const LoadOptions& options) {
  return orbslam::with_settings(bytes, "ORB-SLAM2", options, orbslam::load_orbslam2_settings);
}

ConsumerView load_slam_no_opt(std::string_view bytes, const LoadOptions& options) {
  return orbslam::with_settings(bytes, "slam_no_opt", options, orbslam::load_slam_no_opt_settings);
}

}  // namespace fca::consumers
