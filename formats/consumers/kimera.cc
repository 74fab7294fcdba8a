// SPDX-License-Identifier: BSD-3-Clause
// Kimera-VIO (MIT-SPARK/Kimera-VIO@ce8c59b of 2025-02) as a consumer of its CameraParams and ImuParams: YamlParser.h,
// CameraParams.cpp and ImuFrontendParams.cpp, through cv::FileStorage. A key that is missing is a fatal CHECK, as is a list of
// another length. The words of the models count in any case. rate_hz of a camera is read as an int (29.97 becomes 30); rows and
// cols of T_BS are never read. OpenCV undistorts with all coefficients, as they are.
//
// Its omni cameras are taken as they stand, without a formula of ours.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "about_key.h"
#include "fca/code.h"
#include "opencv_formulas.h"
#include "programs.h"
#include "storage.h"

namespace fca::consumers {
namespace {

constexpr std::string_view kProgram = "Kimera-VIO";
using Numbers = std::vector<double>;

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The keys of a file, and what Kimera-VIO says of them.
class Parameters {
 public:
  Parameters(const cv::FileStorage& storage, ConsumerView& view) : storage_(storage), view_(view) {}

  void refuse(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.refusals.push_back(about_key(code, key, std::move(arguments)));
  }
  void warn(Code code, const std::string& key, std::vector<Argument> arguments = {}) {
    view_.warnings.push_back(about_key(code, key, std::move(arguments)));
  }

  /// A path of keys; an empty node where one is missing, which is reported.
  cv::FileNode require(const std::string& path) {
    const std::size_t slash = path.find('/');
    cv::FileNode node = storage_[path.substr(0, slash)];
    if (slash != std::string::npos && node.isMap()) node = node[path.substr(slash + 1)];
    if (slash != std::string::npos && !storage_[path.substr(0, slash)].isMap()) node = cv::FileNode();
    if (node.empty()) refuse(Code::kProgramSaysMissing, path, {kProgram});
    return node;
  }

  std::string text(const std::string& key) {
    const cv::FileNode node = require(key);
    if (node.empty()) return "";
    if (node.isString() && !node.string().empty()) return node.string();
    refuse(Code::kProgramSaysNoText, key, {kProgram});
    return "";
  }

  std::optional<double> number(const std::string& key) {
    const cv::FileNode node = require(key);
    if (node.empty()) return std::nullopt;
    if (storage::is_number(node)) return static_cast<double>(node);
    refuse(Code::kProgramNoNumber, key, {storage::description_of(node)});
    return std::nullopt;
  }

  /// `count` 0: any.
  std::optional<Numbers> numbers(const std::string& path, std::size_t count) {
    const cv::FileNode node = require(path);
    if (node.empty()) return std::nullopt;
    Numbers values;
    bool good = node.isSeq();
    for (int i = 0; good && i < static_cast<int>(node.size()); ++i) {
      good = storage::is_number(node[i]);
      if (good) values.push_back(static_cast<double>(node[i]));
    }
    if (good && (count == 0 || values.size() == count)) return values;
    refuse(Code::kProgramSaysNumberCount, path, {count, kProgram});
    return std::nullopt;
  }

 private:
  const cv::FileStorage& storage_;
  ConsumerView& view_;
};

bool is_radtan(const std::string& name) { return name == "plumb_bob" || name == "radial-tangential" || name == "radtan"; }

/// True where it goes on.
bool check_coefficients(Parameters& file, const std::string& distortion, const Numbers& coefficients) {
  constexpr std::size_t kFour = 4;
  const std::string key = "distortion_coefficients";
  if (coefficients.size() < kFour) {
    file.refuse(Code::kKimeraSaysFewCoefficients, key, {coefficients.size()});
    return false;
  }
  if (distortion == "equidistant" && coefficients.size() != kFour) {
    file.refuse(Code::kKimeraSaysFourCoefficients, key, {coefficients.size()});
    return false;
  }
  if (is_radtan(distortion) && coefficients.size() > kFour) file.warn(Code::kKimeraSaysFirstFour, key, {coefficients.size()});
  return true;
}

void read_rate(Parameters& file) {
  const std::optional<double> rate = file.number("rate_hz");
  if (!rate) return;
  const int whole = cv::saturate_cast<int>(*rate);
  if (whole <= 0) {
    file.refuse(Code::kKimeraSaysRateZero, "rate_hz", {*rate, whole});
  } else if (whole != *rate) {
    file.warn(Code::kKimeraSaysRateRounded, "rate_hz", {*rate, whole});
  }
}

using Projection = std::function<std::optional<std::array<double, 2>>(const std::array<double, 3>&)>;

/// In front of the camera: behind it Kimera-VIO projects nothing.
Projection projection(const opencv::CameraMatrix& K, const std::string& distortion, const Numbers& coefficients) {
  if (distortion == "equidistant") {
    std::array<double, 4> k{};
    std::copy_n(coefficients.begin(), k.size(), k.begin());
    return [K, k](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
      if (!(ray[2] > 0.0)) return std::nullopt;
      return opencv::fisheye_project_points(K, k, ray);
    };
  }
  opencv::PinholeCoefficients k{};
  if (is_radtan(distortion)) std::copy_n(coefficients.begin(), std::min(coefficients.size(), k.size()), k.begin());
  return [K, k](const std::array<double, 3>& ray) -> std::optional<std::array<double, 2>> {
    if (!(ray[2] > 0.0)) return std::nullopt;
    return opencv::project_points(K, k, ray);
  };
}

void read_camera(const cv::FileStorage& storage, ConsumerView& view) {
  Parameters file(storage, view);
  file.text("camera_id");
  const std::string model = lower_case(file.text("camera_model"));
  const std::string distortion = lower_case(file.text("distortion_model"));
  if (!model.empty() && model != "pinhole" && model != "omni")
    file.refuse(Code::kKimeraSaysUnknownModel, "camera_model", {model});
  if (model == "omni") file.warn(Code::kKimeraSaysNoOmni, "camera_model");
  const bool known = distortion == "none" || distortion == "equidistant" || is_radtan(distortion);
  if (model == "pinhole" && !distortion.empty() && !known)
    file.refuse(Code::kKimeraSaysUnknownDistortion, "distortion_model", {distortion});
  const std::optional<Numbers> coefficients = file.numbers("distortion_coefficients", 0);
  const bool good = coefficients && check_coefficients(file, distortion, *coefficients);
  const std::optional<Numbers> size = file.numbers("resolution", 2);
  read_rate(file);
  const std::optional<Numbers> pose = file.numbers("T_BS/data", 16);
  const std::optional<Numbers> intrinsics = file.numbers("intrinsics", model == "omni" ? 0 : 4);
  if (!good || !size || !pose || !intrinsics || !view.loads() || model == "omni") return;

  ConsumerCamera camera;
  camera.name = "cam0";
  camera.model = model + ", " + distortion;
  camera.width = cv::saturate_cast<int>((*size)[0]);
  camera.height = cv::saturate_cast<int>((*size)[1]);
  camera.project = projection({.fx = (*intrinsics)[0], .fy = (*intrinsics)[1], .cx = (*intrinsics)[2], .cy = (*intrinsics)[3]},
                              distortion, *coefficients);
  view.cameras.push_back(std::move(camera));
  ConsumerPose in_body = {"imu0", "cam0", {}};
  std::copy_n(pose->begin(), in_body.T_a_b.size(), in_body.T_a_b.begin());
  view.poses.push_back(std::move(in_body));
}

void read_imu(const cv::FileStorage& storage, ConsumerView& view) {
  Parameters file(storage, view);
  file.number("imu_preintegration_type");
  if (const std::optional<Numbers> pose = file.numbers("T_BS/data", 16)) {
    constexpr double kRounding = 1e-9;  // of gtsam::Pose3::equals
    bool is_identity = true;
    for (std::size_t i = 0; i < pose->size(); ++i)
      is_identity = is_identity && std::abs((*pose)[i] - (i % 5 == 0 ? 1.0 : 0.0)) <= kRounding;
    if (!is_identity) file.refuse(Code::kKimeraSaysNoIdentity, "T_BS/data");
  }
  ConsumerImu& imu = view.imu.emplace();
  imu.rate_hz = file.number("rate_hz");
  if (imu.rate_hz && !(*imu.rate_hz > 0.0)) file.refuse(Code::kKimeraSaysRateZero, "rate_hz", {*imu.rate_hz, 0});
  file.number("imu_bias_init_sigma");
  imu.gyroscope_noise_density = file.number("gyroscope_noise_density");
  imu.gyroscope_random_walk = file.number("gyroscope_random_walk");
  imu.accelerometer_noise_density = file.number("accelerometer_noise_density");
  imu.accelerometer_random_walk = file.number("accelerometer_random_walk");
  for (const char* key : {"do_imu_rate_time_alignment", "time_alignment_window_size_s",
                          "time_alignment_variance_threshold_scaling", "imu_integration_sigma", "imu_time_shift"})
    file.number(key);
  file.numbers("n_gravity", 3);
}

}  // namespace

ConsumerView load_kimera(std::string_view bytes, const LoadOptions&) {
  return storage::read(bytes, kProgram, storage::reader_of(kProgram), &read_camera);
}

ConsumerView load_kimera_imu(std::string_view bytes, const LoadOptions&) {
  return storage::read(bytes, kProgram, storage::reader_of(kProgram), &read_imu);
}

}  // namespace fca::consumers
