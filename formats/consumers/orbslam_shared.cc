// SPDX-License-Identifier: BSD-3-Clause
#include "orbslam_shared.h"

#include "opencv_formulas.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

namespace fca::consumers::orbslam {
namespace {

std::optional<Pixel> finite_pixel(double u, double v) {
  if (!std::isfinite(u) || !std::isfinite(v)) return std::nullopt;
  return Pixel{u, v};
}

/// Before OpenCV's reader sees the bytes; what no reader of OpenCV's takes, storage::read refuses.
Message find_obstacle(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const std::string_view head = bytes.substr(first == std::string_view::npos ? 0 : first);
  const bool is_text = bytes.find('\0') == std::string_view::npos;
  if (is_text && head.starts_with("<?xml")) return {Code::kOrbslamXml};
  if (storage::obstacle_of(bytes) != Code::kNone) return {};
  if (!bytes.starts_with("%YAML") && !head.starts_with("{")) return {Code::kOrbslamNoHeader};
  return {};
}

std::vector<Message> suggest_int(const cv::FileNode& node) {
  if (!node.isReal()) return {};
  const double value = node.real();
  if (value != std::floor(value) || std::abs(value) > 1e9) return {};
  return {{Code::kOrbslamWriteInt, {static_cast<int>(value)}}};
}

/// theta + k1 theta^3 + .. + k4 theta^9, in the order of operations of KannalaBrandt8::project.
double theta_polynomial(double theta, const std::array<float, 4>& k) {
  const double theta2 = theta * theta;
  const double theta3 = theta * theta2;
  const double theta5 = theta3 * theta2;
  const double theta7 = theta5 * theta2;
  const double theta9 = theta7 * theta2;
  return theta + k[0] * theta3 + k[1] * theta5 + k[2] * theta7 + k[3] * theta9;
}

}  // namespace

std::optional<Sensor> parse_sensor(std::string_view name) {
  constexpr std::string_view kInertial = "-inertial";
  Sensor sensor;
  sensor.inertial = name.ends_with(kInertial);
  if (sensor.inertial) name.remove_suffix(kInertial.size());
  sensor.stereo = name == "stereo";
  sensor.rgbd = name == "rgbd";
  if (!sensor.stereo && !sensor.rgbd && name != "mono") return std::nullopt;
  return sensor;
}

// The oracle tables of PinHole files are about the distorted image (at newWidth x newHeight): the inverse of what the program
// does with its key points (cv::undistortPoints) or its maps. They are printed in double from parameters kept as float, and so
// is this; Pinhole::project itself (src/CameraModels/Pinhole.cpp) has no distortion. Behind the camera: invalid.
Projection pinhole(const Intrinsics& k, const PinholeDistortion& distortion) {
  return [k, distortion](const Ray& p) -> std::optional<Pixel> {
    if (!(p[2] > 0.0)) return std::nullopt;
    const auto& [k1, k2, p1, p2, k3] = distortion;
    const double x = p[0] / p[2];
    const double y = p[1] / p[2];
    const double r2 = x * x + y * y;
    const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double xd = x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x);
    const double yd = y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y;
    return finite_pixel(k.fx * xd + k.cx, k.fy * yd + k.cy);
  };
}

Unprojection pinhole_rays(const Intrinsics& k, const PinholeDistortion& distortion) {
  const opencv::CameraMatrix K = {k.fx, k.fy, k.cx, k.cy, 0.0};
  opencv::PinholeCoefficients coefficients{};
  std::ranges::copy(distortion, coefficients.begin());
  return opencv::undistorted_rays(K, coefficients);
}

// ORB-SLAM3 V1.0, src/CameraModels/KannalaBrandt8.cpp: angles in float, the polynomial in double. No ray is invalid.
Projection kannala_brandt8(const Intrinsics& k, const std::array<float, 4>& coeffs) {
  return [k, coeffs](const Ray& p) -> std::optional<Pixel> {
    const auto r_xy = std::sqrt(static_cast<float>(p[0] * p[0] + p[1] * p[1]));
    const double theta = std::atan2(r_xy, static_cast<float>(p[2]));
    const double psi = std::atan2(static_cast<float>(p[1]), static_cast<float>(p[0]));
    const double r = theta_polynomial(theta, coeffs);
    return finite_pixel(k.fx * r * std::cos(psi) + k.cx, k.fy * r * std::sin(psi) + k.cy);
  };
}

// KannalaBrandt8::unproject: the distorted angle is cut off at pi/2, ten Newton steps in float, and the tangent of the angle
// they end at is taken, so that the ray has z = 1: a ray from beyond 90 degrees comes out turned round.
Unprojection kannala_brandt8_rays(const Intrinsics& k, const std::array<float, 4>& coeffs) {
  return [k, coeffs](const Pixel& pixel) -> std::optional<Ray> {
    const float x = (static_cast<float>(pixel[0]) - k.cx) / k.fx;
    const float y = (static_cast<float>(pixel[1]) - k.cy) / k.fy;
    constexpr auto kRightAngle = static_cast<float>(std::numbers::pi / 2.0);
    const float theta_d = std::min(std::sqrt(x * x + y * y), kRightAngle);
    constexpr float kOnAxis = 1e-8F;
    if (!(theta_d > kOnAxis)) return Ray{x, y, 1.0};
    constexpr int kSteps = 10;
    constexpr float kPrecision = 1e-6F;
    float theta = theta_d;
    for (int i = 0; i < kSteps; ++i) {
      const float theta2 = theta * theta;
      const float theta4 = theta2 * theta2;
      const float terms[] = {coeffs[0] * theta2, coeffs[1] * theta4, coeffs[2] * theta4 * theta2, coeffs[3] * theta4 * theta4};
      const float value = theta * (1.0F + terms[0] + terms[1] + terms[2] + terms[3]) - theta_d;
      const float derivative = 1.0F + 3.0F * terms[0] + 5.0F * terms[1] + 7.0F * terms[2] + 9.0F * terms[3];
      const float step = value / derivative;
      theta -= step;
      if (std::abs(step) < kPrecision) break;
    }
    const float scale = std::tan(theta) / theta_d;
    if (!std::isfinite(scale)) return std::nullopt;
    return Ray{x * scale, y * scale, 1.0};
  };
}

// urbste/ORB_SLAM3, src/CameraModels/DoubleSphere.cpp. It marks an invalid ray by the pixel (0, 0).
Projection double_sphere(const Intrinsics& k, float xi_float, float alpha_float) {
  return
      [k, xi = static_cast<double>(xi_float), alpha = static_cast<double>(alpha_float)](const Ray& p) -> std::optional<Pixel> {
        const double r2 = p[0] * p[0] + p[1] * p[1];
        const double d1 = std::sqrt(r2 + p[2] * p[2]);
        const double w1 = alpha > 0.5 ? (1.0 - alpha) / alpha : alpha / (1.0 - alpha);
        const double w2 = (w1 + xi) / std::sqrt(2.0 * w1 * xi + xi * xi + 1.0);
        if (!(p[2] > -w2 * d1)) return std::nullopt;
        const double shifted = xi * d1 + p[2];
        const double d2 = std::sqrt(r2 + shifted * shifted);
        const double denominator = alpha * d2 + (1.0 - alpha) * shifted;
        return finite_pixel(k.fx * (p[0] / denominator) + k.cx, k.fy * (p[1] / denominator) + k.cy);
      };
}

// ns15417/slam_no_opt, src/CameraModels/EUCM.cpp, all in float. Its limit R2max is negative for alpha < 0.5, which refuses
// every point (alpha = 0.5 exactly gives +infinity, which refuses none). It does not look at the sign of the denominator.
Projection eucm(const Intrinsics& k, float alpha, float beta) {
  const float r2_max = 1.0F / (beta * (2.0F * alpha - 1.0F));
  return [k, alpha, beta, r2_max](const Ray& p) -> std::optional<Pixel> {
    const auto x = static_cast<float>(p[0]);
    const auto y = static_cast<float>(p[1]);
    const auto z = static_cast<float>(p[2]);
    const float d = std::sqrt(beta * (x * x + y * y) + z * z);
    const float mx = x / (alpha * d + (1.0F - alpha) * z);
    const float my = y / (alpha * d + (1.0F - alpha) * z);
    if (mx * mx + my * my > r2_max) return std::nullopt;
    return finite_pixel(k.fx * mx + k.cx, k.fy * my + k.cy);
  };
}

void Settings::refuse_missing(std::string_view key) { refuse_at(key, Code::kOrbslamKeyMissing, {program_}); }

float Settings::real(std::string_view key, bool required) {
  const cv::FileNode found = node(key);
  if (found.empty()) {
    if (required) refuse_missing(key);
    return 0.0F;
  }
  if (!found.isReal()) {
    std::vector<Message> suggestion;
    if (found.isInt()) suggestion = {{Code::kProgramWriteReal, {static_cast<int>(found)}}};
    refuse_at(key, Code::kOrbslamNotReal, {description_of(found), program_, suggestion});
    return 0.0F;
  }
  return static_cast<float>(found.real());
}

int Settings::integer(std::string_view key, bool required) {
  const cv::FileNode found = node(key);
  if (found.empty()) {
    if (required) refuse_missing(key);
    return 0;
  }
  if (!found.isInt()) {
    refuse_at(key, Code::kOrbslamNotInt, {description_of(found), program_, suggest_int(found)});
    return 0;
  }
  return static_cast<int>(found);
}

std::string Settings::text(std::string_view key, bool required) {
  const cv::FileNode found = node(key);
  if (found.empty()) {
    if (required) refuse_missing(key);
    return {};
  }
  if (!found.isString()) {
    refuse_at(key, Code::kOrbslamNotText, {description_of(found), program_});
    return {};
  }
  return found.string();
}

float Settings::loose(std::string_view key) {
  const cv::FileNode found = node(key);
  if (found.empty()) return 0.0F;
  if (storage::is_number(found)) return static_cast<float>(found);
  warn_at(key, Code::kOrbslamTakesLargest, {description_of(found), program_});
  return std::numeric_limits<float>::max();  // cv::read(FileNode, float&)
}

std::optional<cv::Mat> Settings::matrix(std::string_view key) {
  const cv::FileNode found = node(key);
  if (found.empty()) {
    refuse_missing(key);
    return std::nullopt;
  }
  try {
    if (found.isMap()) return storage::read_matrix(found);
    refuse_at(key, Code::kOrbslamNoMatrix, {description_of(found), program_});
  } catch (const cv::Exception& error) {
    refuse_at(key, Code::kOrbslamUnreadableMatrix, {storage::fault_of(error), program_});
  }
  return std::nullopt;
}

ConsumerView with_settings(std::string_view bytes, std::string_view program, const LoadOptions& options,
                           const std::function<void(Settings&, const Sensor&, ConsumerView&)>& body) {
  ConsumerView view;
  const std::optional<Sensor> sensor = parse_sensor(options.sensor);
  const Message obstacle = sensor ? find_obstacle(bytes) : Message{Code::kOrbslamNoSensor, {options.sensor}};
  if (obstacle.is_said()) {
    view.refusals.emplace_back(obstacle.code, "", obstacle.arguments);
    return view;
  }
  return storage::read(bytes, program, storage::reader_of(program), [&](const cv::FileStorage& storage, ConsumerView& opened) {
    Settings settings(storage, program, opened);
    body(settings, *sensor, opened);
  });
}

std::optional<std::array<double, 16>> rows_as_float(const cv::Mat& matrix) {
  if (matrix.dims != 2 || matrix.rows < 3 || matrix.cols < 4) return std::nullopt;
  const std::size_t row_bytes = matrix.elemSize() * static_cast<std::size_t>(matrix.cols);
  if (row_bytes < 4 * sizeof(float)) return std::nullopt;
  std::array<double, 16> pose{};
  for (int r = 0; r < 3; ++r) {
    std::array<float, 4> row{};
    std::memcpy(row.data(), matrix.ptr(r), sizeof(row));
    std::copy(row.begin(), row.end(), pose.begin() + 4 * r);
  }
  pose.back() = 1.0;
  return pose;
}

std::optional<std::array<double, 16>> pointer_as_float(const cv::Mat& matrix) {
  std::array<float, 16> values{};
  if (matrix.empty() || !matrix.isContinuous() || matrix.total() * matrix.elemSize() < sizeof(values)) return std::nullopt;
  std::memcpy(values.data(), matrix.ptr(), sizeof(values));
  std::array<double, 16> pose{};
  std::copy(values.begin(), values.end(), pose.begin());
  return pose;
}

double rotation_error(const std::array<double, 16>& pose) {
  double sum = 0.0;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      double dot = r == c ? -1.0 : 0.0;
      for (std::size_t i = 0; i < 3; ++i) dot += pose.at(r * 4 + i) * pose.at(c * 4 + i);
      sum += dot * dot;
    }
  }
  return std::sqrt(sum);
}

void warn_unless_float(Settings& settings, std::string_view key, const cv::Mat& matrix) {
  if (matrix.type() == CV_32F) return;
  settings.warn_at(key, matrix.type() == CV_64F ? Code::kOrbslamPoseOfDoubles : Code::kOrbslamPoseNotOfFloats,
                   {settings.program()});
}

ConsumerImu read_noise(Settings& settings) {
  ConsumerImu imu;
  imu.gyroscope_noise_density = settings.real("IMU.NoiseGyro");
  imu.accelerometer_noise_density = settings.real("IMU.NoiseAcc");
  imu.gyroscope_random_walk = settings.real("IMU.GyroWalk");
  imu.accelerometer_random_walk = settings.real("IMU.AccWalk");
  return imu;
}

ConsumerPose rectified_baseline(double baseline) {
  return {"cam0", "cam1", {1, 0, 0, baseline, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
}

}  // namespace fca::consumers::orbslam
