// SPDX-License-Identifier: BSD-3-Clause
// PyCuVSLAM's EuRoC example (NVlabs/PyCuVSLAM@f1fb2b8, examples/euroc) as a consumer of sensor.yaml, through PyYAML. The first
// key that begins with T_ is the pose (T_BS or T_Cam0, 16 numbers below data). distortion_model is never read: the coefficients
// of a sensor.yaml are k1 k2 p1 p2 of cuVSLAM's Brown model, those of a sensor_recalibrated.yaml of its Fisheye model. A file
// with camera_model fisheye, as that example's, is taken for the latter under any name; without a name (LoadOptions) the
// numbers' own is meant. Its TUM and RealSense examples (examples/tum, examples/realsense) have rig files of their own.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "about_key.h"
#include "fca/code.h"
#include "opencv_formulas.h"
#include "programs.h"
#include "pyyaml.h"

namespace fca::consumers {
namespace {

using pyyaml::Kind;
using pyyaml::Value;

/// The keys of a file, and what the example says of them.
constexpr std::string_view kExample = "cuVSLAM's EuRoC example";

class Sensor {
 public:
  Sensor(const Value& root, ConsumerView& view) : root_(root), view_(view) {}

  void refuse(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.refusals.push_back(about_key(code, key, std::move(arguments)));
  }

  const Value* require(const std::string& key) {
    const Value* value = root_.find(key);
    if (value == nullptr) refuse(Code::kProgramSaysMissing, key, {kExample});
    return value;
  }

  std::optional<double> number(const std::string& key) {
    const Value* value = require(key);
    if (value == nullptr) return std::nullopt;
    if (value->is_number()) return value->number;
    refuse(Code::kProgramSaysNoNumber, key, {pyyaml::describe(*value), kExample});
    return std::nullopt;
  }

  std::optional<std::vector<double>> numbers(const Value* list, const std::string& path, std::size_t count) {
    if (list == nullptr) return std::nullopt;
    std::vector<double> values;
    if (list->kind == Kind::kList) {
      for (const pyyaml::ValuePtr& item : list->items) {
        if (item->is_number()) values.push_back(item->number);
      }
    }
    if (list->kind == Kind::kList && list->items.size() == count && values.size() == count) return values;
    refuse(Code::kProgramSaysNumberCount, path, {count, kExample});
    return std::nullopt;
  }
  std::optional<std::vector<double>> numbers(const std::string& key, std::size_t count) {
    return numbers(require(key), key, count);
  }

  /// The frame ("imu0" of T_BS: the body) with the pose in it.
  std::optional<ConsumerPose> pose() {
    for (const auto& [key, value] : root_.entries) {
      if (!key->text.starts_with("T_")) continue;
      const std::string path = key->text + "/data";
      const Value* data = value->kind == Kind::kMap ? value->find("data") : nullptr;
      if (data == nullptr) refuse(Code::kProgramSaysMissing, path, {kExample});
      const std::optional<std::vector<double>> matrix = numbers(data, path, 16);
      if (!matrix) return std::nullopt;
      ConsumerPose pose = {key->text == "T_Cam0" ? "" : "imu0", "", {}};
      std::copy_n(matrix->begin(), pose.T_a_b.size(), pose.T_a_b.begin());
      return pose;
    }
    view_.refusals.emplace_back(Code::kCuvslamSaysNoPose, "");
    return std::nullopt;
  }

 private:
  const Value& root_;
  ConsumerView& view_;
};

pyyaml::ValuePtr load_map(std::string_view bytes, ConsumerView& view) {
  pyyaml::Loaded loaded = pyyaml::safe_load(bytes);
  if (!loaded.root) {
    view.refusals.emplace_back(Code::kProgramSaysNotParsed, "", std::vector<Argument>{"PyYAML", loaded.error});
    return nullptr;
  }
  if (loaded.root->kind == Kind::kMap) return loaded.root;
  view.refusals.emplace_back(Code::kProgramSaysNoKeys, "");
  return nullptr;
}

std::string text_at(const Value& root, std::string_view key) {
  const Value* value = root.find(key);
  return value != nullptr && value->kind == Kind::kString ? value->text : std::string();
}

/// What cuVSLAM does with rays from behind is not documented: none here.
ConsumerCamera camera_of(const std::vector<double>& k, const std::vector<double>& d, bool is_fisheye) {
  const opencv::CameraMatrix K = {.fx = k[0], .fy = k[1], .cx = k[2], .cy = k[3]};
  ConsumerCamera camera;
  camera.name = "cam0";
  camera.model = is_fisheye ? "Fisheye" : "Brown";
  camera.project = [K, d, is_fisheye](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
    if (!(ray[2] > 0.0)) return std::nullopt;
    if (is_fisheye) return opencv::fisheye_project_points(K, {d[0], d[1], d[2], d[3]}, ray);
    return opencv::project_points(K, {d[0], d[1], d[2], d[3]}, ray);
  };
  return camera;
}

/// The camera of the TUM example's freiburg3_rig.yaml, which undistorts nothing.
ConsumerView load_colour_camera(const Value& camera, ConsumerView view) {
  Sensor sensor(camera, view);
  const auto focal = sensor.numbers("focal_length", 2);
  const auto centre = sensor.numbers("principal_point", 2);
  const auto width = sensor.number("image_width");
  const auto height = sensor.number("image_height");
  if (!view.loads() || !focal || !centre || !width || !height) return view;
  ConsumerCamera seen = camera_of({(*focal)[0], (*focal)[1], (*centre)[0], (*centre)[1]}, {0.0, 0.0, 0.0, 0.0}, false);
  seen.model = "Pinhole";
  seen.width = static_cast<int>(*width);
  seen.height = static_cast<int>(*height);
  view.cameras.push_back(std::move(seen));
  return view;
}

/// The poses of the RealSense example's frame_agx_rig.yaml: rig_from_camera.
ConsumerView load_pairs(const Value& pairs, ConsumerView view) {
  for (const pyyaml::ValuePtr& pair : pairs.items) {
    for (const char* side : {"left_camera", "right_camera"}) {
      const Value* camera = pair->kind == Kind::kMap ? pair->find(side) : nullptr;
      const Value* rows = camera != nullptr && camera->kind == Kind::kMap ? camera->find("transform") : nullptr;
      const std::string path = std::string("stereo_cameras/") + side + "/transform";
      ConsumerPose pose = {"rig", "cam" + std::to_string(view.poses.size()), {}};
      pose.T_a_b.back() = 1.0;
      std::size_t count = 0;
      for (std::size_t row = 0; rows != nullptr && row < rows->items.size(); ++row) {
        for (const pyyaml::ValuePtr& number : rows->items[row]->items) {
          if (number->is_number() && count < 12) pose.T_a_b.at(count++) = number->number;
        }
      }
      if (count != 12 || rows->items.size() != 3) {
        view.refusals.push_back(
            about_key(rows == nullptr ? Code::kProgramSaysMissing : Code::kProgramSaysNumberCount, path,
                      rows == nullptr ? std::vector<Argument>{kExample} : std::vector<Argument>{12, kExample}));
        view.poses.clear();
        return view;
      }
      view.poses.push_back(std::move(pose));
    }
  }
  return view;
}

}  // namespace

ConsumerView load_cuvslam(std::string_view bytes, const LoadOptions& options) {
  ConsumerView view;
  const pyyaml::ValuePtr root = load_map(bytes, view);
  if (!root) return view;
  if (const Value* camera = root->find("rgb_camera"); camera != nullptr && camera->kind == Kind::kMap)
    return load_colour_camera(*camera, std::move(view));
  Sensor sensor(*root, view);
  std::optional<ConsumerPose> pose = sensor.pose();
  const auto intrinsics = sensor.numbers("intrinsics", 4);
  const auto coefficients = sensor.numbers("distortion_coefficients", 4);
  const auto size = sensor.numbers("resolution", 2);
  if (!view.loads() || !pose || !intrinsics || !coefficients || !size) return view;
  const std::string distortion = text_at(*root, "distortion_model");
  const bool is_equidistant = distortion == "equidistant";
  constexpr std::string_view kRightName = "sensor_recalibrated.yaml";
  const bool has_right_name = options.file_name.empty() ? is_equidistant : options.file_name.ends_with(kRightName);
  const bool is_fisheye = text_at(*root, "camera_model") == "fisheye" || has_right_name;
  const bool is_misread = is_equidistant && !is_fisheye;
  if (options.file_name.empty() && is_equidistant && text_at(*root, "camera_model") != "fisheye") view.wanted_name = kRightName;
  if (is_misread) {
    const std::string key = "distortion_model";
    view.warnings.emplace_back(Code::kCuvslamSaysTakenForBrown, key, std::vector<Argument>{key, distortion});
  }
  ConsumerCamera camera = camera_of(*intrinsics, *coefficients, is_fisheye);
  camera.misread = is_misread;
  camera.width = static_cast<int>((*size)[0]);
  camera.height = static_cast<int>((*size)[1]);
  view.cameras.push_back(std::move(camera));
  pose->b = "cam0";
  if (!pose->a.empty()) view.poses.push_back(*std::move(pose));
  return view;
}

ConsumerView load_cuvslam_imu(std::string_view bytes, const LoadOptions& /*options*/) {
  ConsumerView view;
  const pyyaml::ValuePtr root = load_map(bytes, view);
  if (!root) return view;
  if (const Value* pairs = root->find("stereo_cameras"); pairs != nullptr && pairs->kind == Kind::kList)
    return load_pairs(*pairs, std::move(view));
  Sensor sensor(*root, view);
  sensor.pose();
  ConsumerImu& imu = view.imu.emplace();
  imu.rate_hz = sensor.number("rate_hz");
  imu.gyroscope_noise_density = sensor.number("gyroscope_noise_density");
  imu.gyroscope_random_walk = sensor.number("gyroscope_random_walk");
  imu.accelerometer_noise_density = sensor.number("accelerometer_noise_density");
  imu.accelerometer_random_walk = sensor.number("accelerometer_random_walk");
  return view;
}

}  // namespace fca::consumers
