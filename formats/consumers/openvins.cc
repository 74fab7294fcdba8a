// SPDX-License-Identifier: BSD-3-Clause
// OpenVINS (rpng/open_vins@6948812) as a consumer of kalibr_imucam_chain.yaml and kalibr_imu_chain.yaml: Kalibr's keys, read by
// cv::FileStorage (ov_core/src/utils/opencv_yaml_parse.h) as ov_msckf/src/core/VioManagerOptions.h asks for them; the formulas
// are CamEqui.h's and CamRadtan.h's distort_f.
//
// A key that is missing ends the program (YamlParser::successful), and so does a list that is too short (std::vector::at). How
// many cameras it reads stands in its main file (max_cameras): here cam0, cam1, ... as far as they go.
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>

#include "about_key.h"
#include "fca/code.h"
#include "fca/rig/limits.h"
#include "opencv_formulas.h"
#include "programs.h"
#include "storage.h"

namespace fca::consumers {
namespace {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Projection = std::function<std::optional<Pixel>(const Ray&)>;

constexpr std::string_view kProgram = "OpenVINS";

/// camera_values: fx fy cx cy and four coefficients, in double; points come and go in float.
using CameraValues = std::array<double, 8>;

Pixel to_pixel(const CameraValues& d, double x, double y) {
  return {static_cast<double>(static_cast<float>(d[0] * x + d[2])), static_cast<double>(static_cast<float>(d[1] * y + d[3]))};
}

// CamEqui::distort_f
Pixel distort_equidistant(const CameraValues& d, float x, float y) {
  const double r = std::sqrt(x * x + y * y);
  const double theta = std::atan(r);
  const double theta_d =
      theta + d[4] * std::pow(theta, 3) + d[5] * std::pow(theta, 5) + d[6] * std::pow(theta, 7) + d[7] * std::pow(theta, 9);
  const double scale = r > 1e-8 ? theta_d / r : 1.0;
  return to_pixel(d, x * scale, y * scale);
}

// CamRadtan::distort_f
Pixel distort_radtan(const CameraValues& d, float x, float y) {
  const double r = std::sqrt(x * x + y * y);
  const double r2 = r * r;
  const double radial = 1.0 + d[4] * r2 + d[5] * r2 * r2;
  return to_pixel(d, x * radial + 2.0 * d[6] * x * y + d[7] * (r2 + 2.0 * x * x),
                  y * radial + d[6] * (r2 + 2.0 * y * y) + 2.0 * d[7] * x * y);
}

// CamRadtan::undistort_f: cv::undistortPoints.
std::function<std::optional<Ray>(const Pixel&)> rays_of(const CameraValues& d) {
  const opencv::CameraMatrix K = {d[0], d[1], d[2], d[3], 0.0};
  opencv::PinholeCoefficients coefficients{};
  std::copy_n(d.begin() + 4, 4, coefficients.begin());
  return opencv::undistorted_rays(K, coefficients);
}

/// Features behind the camera are rejected when they are triangulated.
Projection projection(const CameraValues& values, bool is_equidistant) {
  return [values, is_equidistant](const Ray& ray) -> std::optional<Pixel> {
    if (!(ray[2] > 0.0)) return std::nullopt;
    const auto x = static_cast<float>(ray[0] / ray[2]);
    const auto y = static_cast<float>(ray[1] / ray[2]);
    const Pixel pixel = is_equidistant ? distort_equidistant(values, x, y) : distort_radtan(values, x, y);
    if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1])) return std::nullopt;
    return pixel;
  };
}

using storage::is_number;

/// list[index], or an empty node.
cv::FileNode item(const cv::FileNode& list, int index) {
  return list.isSeq() && index < static_cast<int>(list.size()) ? list[index] : cv::FileNode();
}

/// A sensor's map in a file, and the sentences about it.
class Sensor {
 public:
  Sensor(const cv::FileNode& node, std::string name, ConsumerView& view) : node_(node), name_(std::move(name)), view_(view) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] cv::FileNode node(const std::string& key) const { return node_[key]; }
  [[nodiscard]] bool has(const std::string& key) const { return !node(key).empty(); }
  [[nodiscard]] std::string text(const std::string& key) const {
    const cv::FileNode found = node(key);
    return found.isString() ? found.string() : std::string();
  }
  void refuse(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.refusals.push_back(about_key(code, path(key), std::move(arguments)));
  }
  void warn(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.warnings.push_back(about_key(code, path(key), std::move(arguments)));
  }

  bool require(const std::string& key) {
    if (has(key)) return true;
    refuse(Code::kOpenVinsSaysKeyMissing, key);
    return false;
  }

  /// node >> std::vector<double>, of which the first `count` are used.
  std::optional<std::vector<double>> numbers(const std::string& key, std::size_t count) {
    if (!require(key)) return std::nullopt;
    const cv::FileNode list = node(key);
    std::vector<double> values;
    bool all_numbers = list.isSeq();
    for (int i = 0; all_numbers && i < static_cast<int>(list.size()); ++i) {
      all_numbers = is_number(item(list, i));
      if (all_numbers) values.push_back(static_cast<double>(item(list, i)));
    }
    if (all_numbers && values.size() >= count) return values;
    if (all_numbers) {
      refuse(Code::kOpenVinsSaysTooFewNumbers, key, {values.size(), count});
    } else {
      refuse(Code::kOpenVinsSaysNoNumbers, key);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::string path(const std::string& key) const { return name_ + "/" + key; }

  cv::FileNode node_;
  std::string name_;
  ConsumerView& view_;
};

/// T_imu_cam, or T_cam_imu where that is missing; what the lists lack stays the identity's.
struct Extrinsics {
  bool is_T_imu_cam = true;
  std::array<double, 16> T = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
};

std::optional<Extrinsics> read_extrinsics(Sensor& sensor) {
  Extrinsics result;
  result.is_T_imu_cam = sensor.has("T_imu_cam");
  const std::string key = result.is_T_imu_cam ? "T_imu_cam" : "T_cam_imu";
  if (!sensor.has(key)) {
    sensor.refuse(Code::kOpenVinsSaysPoseMissing, "T_cam_imu");
    return std::nullopt;
  }
  const cv::FileNode rows = sensor.node(key);
  bool whole = true;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const cv::FileNode value = item(item(rows, row), column);
      whole = whole && is_number(value);
      if (is_number(value)) result.T.at(static_cast<std::size_t>(4 * row + column)) = static_cast<double>(value);
    }
  }
  if (!whole) sensor.warn(Code::kOpenVinsSaysPoseNotWhole, key);
  return result;
}

void read_camera(Sensor& sensor, ConsumerView& view) {
  const std::size_t refusals = view.refusals.size();
  sensor.require("distortion_model");
  const std::string distortion = sensor.text("distortion_model");
  const auto intrinsics = sensor.numbers("intrinsics", 4);
  const auto coefficients = sensor.numbers("distortion_coeffs", 4);
  const auto resolution = sensor.numbers("resolution", 2);
  const auto extrinsics = read_extrinsics(sensor);
  if (view.refusals.size() != refusals) return;

  CameraValues values{};
  std::copy_n(intrinsics->begin(), 4, values.begin());
  std::copy_n(coefficients->begin(), 4, values.begin() + 4);
  const bool is_equidistant = distortion == "equidistant";
  ConsumerCamera camera;
  camera.model = is_equidistant ? "CamEqui" : "CamRadtan";
  camera.name = sensor.name();
  camera.width = cv::saturate_cast<int>((*resolution)[0]);
  camera.height = cv::saturate_cast<int>((*resolution)[1]);
  camera.project = projection(values, is_equidistant);
  if (!is_equidistant) {
    camera.unproject = rays_of(values);
    camera.unproject_fault = {Code::kRaysInFiveSteps};
  }
  // Of the others it is not read.
  if (sensor.name() == "cam0" && is_number(sensor.node("timeshift_cam_imu")))
    camera.time_offset_s = static_cast<double>(sensor.node("timeshift_cam_imu"));
  const std::string model = sensor.text("camera_model");
  if (!model.empty() && model != "pinhole") {
    camera.misread = true;
    sensor.warn(Code::kOpenVinsSaysModelNotRead, "camera_model", {model});
  } else if (!is_equidistant && distortion != "radtan") {
    camera.misread = distortion != "none";
    sensor.warn(Code::kOpenVinsSaysDistortionNotRead, "distortion_model", {distortion});
  }
  view.cameras.push_back(std::move(camera));
  view.poses.push_back(
      {extrinsics->is_T_imu_cam ? "imu0" : sensor.name(), extrinsics->is_T_imu_cam ? sensor.name() : "imu0", extrinsics->T});
}

void read_chain(const cv::FileStorage& storage, ConsumerView& view) {
  if (storage["cam0"].empty()) {
    view.refusals.emplace_back(Code::kOpenVinsSaysKeyMissing, "cam0", std::vector<Argument>{"cam0"});
    return;
  }
  for (int i = 0; !storage["cam" + std::to_string(i)].empty(); ++i) {
    Sensor sensor(storage["cam" + std::to_string(i)], "cam" + std::to_string(i), view);
    read_camera(sensor, view);
    if (i == 0 || !sensor.has("timeshift_cam_imu")) continue;
    const double behind_first =
        static_cast<double>(sensor.node("timeshift_cam_imu")) - static_cast<double>(storage["cam0"]["timeshift_cam_imu"]);
    if (!(std::abs(behind_first) <= kSameClock)) sensor.warn(Code::kOpenVinsSaysTimeshiftNotRead, "timeshift_cam_imu");
  }
}

void read_imu(const cv::FileStorage& storage, ConsumerView& view) {
  if (storage["imu0"].empty()) {
    view.refusals.emplace_back(Code::kOpenVinsSaysImuMissing, "imu0", std::vector<Argument>{"imu0"});
    return;
  }
  Sensor imu(storage["imu0"], "imu0", view);
  const auto number = [&imu](const char* key) -> std::optional<double> {
    if (!imu.require(key)) return std::nullopt;
    const cv::FileNode value = imu.node(key);
    if (is_number(value)) return static_cast<double>(value);
    imu.refuse(Code::kProgramNoNumber, key, {storage::description_of(value)});
    return std::nullopt;
  };
  ConsumerImu& noise = view.imu.emplace();
  noise.gyroscope_noise_density = number("gyroscope_noise_density");
  noise.gyroscope_random_walk = number("gyroscope_random_walk");
  noise.accelerometer_noise_density = number("accelerometer_noise_density");
  noise.accelerometer_random_walk = number("accelerometer_random_walk");
  for (const char* key : {"Tw", "Ta", "R_IMUtoACC", "R_IMUtoGYRO", "Tg"}) imu.require(key);
}

}  // namespace

ConsumerView load_openvins(std::string_view bytes, const LoadOptions&) {
  return storage::read(bytes, kProgram, storage::reader_of(kProgram), &read_chain);
}

ConsumerView load_openvins_imu(std::string_view bytes, const LoadOptions&) {
  return storage::read(bytes, kProgram, storage::reader_of(kProgram), &read_imu);
}

}  // namespace fca::consumers
