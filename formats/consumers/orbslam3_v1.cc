// SPDX-License-Identifier: BSD-3-Clause
// ORB-SLAM3 V1.0, src/Settings.cc (UZ-SLAMLab@0df83dde): the parser of files with `File.version: "1.0"`. Every type is strict,
// and the process ends at the first wrong or missing key; here all of them are listed.
#include <algorithm>
#include <array>
#include <cmath>

#include "orbslam_shared.h"

namespace fca::consumers::orbslam {
namespace {

constexpr std::array<std::string_view, 4> kRadialKeys = {"k1", "k2", "k3", "k4"};
constexpr std::array<std::string_view, 5> kPinholeKeys = {"k1", "k2", "p1", "p2", "k3"};

/// One camera as read, before rescaling.
struct Camera {
  Intrinsics k;
  PinholeDistortion pinhole{};
  bool has_distortion = false;
  bool has_k3 = false;
  std::array<float, 4> radial{};
  bool misread = false;  ///< the program takes other numbers than the file specifies for this camera
};

class Parser {
 public:
  Parser(Settings& settings, const Sensor& sensor, ConsumerView& view) : settings_(settings), sensor_(sensor), view_(view) {}

  void run() {
    read_type();
    if (type_.empty()) return;
    read_camera1();
    if (sensor_.stereo) read_camera2();
    read_image_info();
    if (sensor_.inertial) read_imu();
    if (sensor_.rgbd) read_rgbd();
    read_strict_lists();
    read_optional();
    if (view_.loads()) add_cameras();
  }

 private:
  [[nodiscard]] bool is_pinhole() const { return type_ == "PinHole"; }
  [[nodiscard]] bool is_fisheye() const { return type_ == "KannalaBrandt8"; }
  [[nodiscard]] bool is_rectified() const { return type_ == "Rectified"; }
  /// Stereo PinHole images are rectified by maps from the original calibration, so nothing is rescaled.
  [[nodiscard]] bool is_remapped() const { return is_pinhole() && sensor_.stereo; }

  void read_type() {
    const std::string type = settings_.text("Camera.type");
    if (type == "PinHole" || type == "Rectified" || type == "KannalaBrandt8") {
      type_ = type;
    } else if (settings_.node("Camera.type").isString()) {
      std::vector<Message> hint;
      if (type.find('#') != std::string::npos) hint = {{Code::kOrbslamCommentInText}};
      settings_.refuse_at("Camera.type", Code::kOrbslamV1Type, {description_of(settings_.node("Camera.type")), hint});
    }
  }

  Intrinsics read_intrinsics(const std::string& camera) {
    return {settings_.real(camera + ".fx"), settings_.real(camera + ".fy"), settings_.real(camera + ".cx"),
            settings_.real(camera + ".cy")};
  }

  void read_pinhole_distortion(const std::string& camera, Camera& result) {
    result.has_distortion = settings_.has(camera + ".k1");
    result.has_k3 = result.has_distortion && settings_.has(camera + ".k3");
    if (!result.has_distortion) {
      for (const std::string_view key : kPinholeKeys) {
        const std::string name = camera + "." + std::string(key);
        if (settings_.has(name)) settings_.warn_at(name, Code::kOrbslamIgnoredWithoutK1, {camera + ".k1"});
      }
      return;
    }
    for (std::size_t i = 0; i < kPinholeKeys.size(); ++i) {
      const bool is_k3 = i + 1 == kPinholeKeys.size();
      result.pinhole.at(i) = settings_.real(camera + "." + std::string(kPinholeKeys.at(i)), !is_k3);
    }
  }

  std::array<float, 4> read_radial(const std::string& camera) {
    std::array<float, 4> radial{};
    for (std::size_t i = 0; i < radial.size(); ++i)
      radial.at(i) = settings_.real(camera + "." + std::string(kRadialKeys.at(i)));
    return radial;
  }

  void read_overlap(const std::string& camera) {
    settings_.integer(camera + ".overlappingBegin");
    settings_.integer(camera + ".overlappingEnd");
  }

  [[nodiscard]] bool states_distortion(const std::string& camera) {
    constexpr std::array kCoefficients = {".k1", ".k2", ".p1", ".p2", ".k3"};
    return std::ranges::any_of(kCoefficients, [&](const char* name) {
      const cv::FileNode number = settings_.node(camera + name);
      return storage::is_number(number) && static_cast<double>(number) != 0.0;
    });
  }

  void read_camera1() {
    first_.k = read_intrinsics("Camera1");
    if (is_pinhole()) read_pinhole_distortion("Camera1", first_);
    if (is_fisheye()) first_.radial = read_radial("Camera1");
    if (is_fisheye() && sensor_.stereo) read_overlap("Camera1");
    if (is_rectified() && states_distortion("Camera1")) settings_.warn_at("Camera1.k1", Code::kOrbslamRectifiedIgnores);
    if (is_fisheye() && sensor_.rgbd && sensor_.inertial) settings_.refuse(Code::kOrbslamSecondNeverRead);
  }

  void read_camera2() {
    if (is_rectified()) {
      read_rectified_baseline();
    } else {
      second_.k = read_intrinsics("Camera2");
      if (is_pinhole()) read_second_distortion();
      if (is_fisheye()) read_second_radial();
      read_stereo_pose();
    }
    settings_.real("Stereo.ThDepth");
  }

  void read_rectified_baseline() {
    baseline_ = settings_.real("Stereo.b");
    constexpr std::array<std::string_view, 4> kKeys = {"fx", "fy", "cx", "cy"};
    const bool differs = std::any_of(kKeys.begin(), kKeys.end(), [this](std::string_view key) {
      const cv::FileNode first = settings_.node("Camera1." + std::string(key));
      const cv::FileNode second = settings_.node("Camera2." + std::string(key));
      return second.isReal() && first.isReal() && first.real() != second.real();
    });
    if (differs) settings_.warn(Code::kOrbslamRectifiedAlike);
  }

  /// camera2DistortionCoef() in include/Settings.h returns the numbers of camera 1 with the count of camera 2.
  void read_second_distortion() {
    Camera own;
    read_pinhole_distortion("Camera2", own);
    second_.has_distortion = own.has_distortion;
    if (own.has_distortion && !first_.has_distortion) {
      settings_.refuse_at("Camera2.k1", Code::kOrbslamReadsNull);
      return;
    }
    if (!own.has_distortion) return;
    second_.pinhole = first_.pinhole;
    if (!own.has_k3) second_.pinhole.back() = 0.0F;
    if (own.has_k3 && !first_.has_k3) settings_.warn_at("Camera2.k3", Code::kOrbslamReadsAfterFour);
    if (own.pinhole != second_.pinhole) {
      second_.misread = true;
      settings_.warn_at("Camera2.k1", Code::kOrbslamSecondPinholeIgnored);
      settings_.last_warning_costs_pixels();
    }
  }

  /// readCamera2 asks for the keys of Camera1.
  void read_second_radial() {
    second_.radial = first_.radial;
    for (const std::string_view key : kRadialKeys) {
      const cv::FileNode first = settings_.node("Camera1." + std::string(key));
      const cv::FileNode second = settings_.node("Camera2." + std::string(key));
      if (!second.isReal() || !first.isReal() || first.real() == second.real()) continue;
      second_.misread = true;
      settings_.warn_from("Camera2.k1", Code::kOrbslamSecondFisheyeIgnored);
      settings_.last_warning_costs_pixels();
      break;
    }
    read_overlap("Camera2");
  }

  void read_stereo_pose() { read_pose("Stereo.T_c1_c2", "cam0", "cam1"); }

  /// Converter::toSophus: at<float>, then a quaternion.
  void read_pose(std::string_view key, std::string a, std::string b) {
    const std::optional<cv::Mat> matrix = settings_.matrix(key);
    if (!matrix) return;
    const auto pose = rows_as_float(*matrix);
    if (!pose) {
      settings_.refuse_at(key, Code::kOrbslamPoseSize, {matrix->rows, matrix->cols});
      return;
    }
    warn_unless_float(settings_, key, *matrix);
    constexpr double kNoticeable = 1e-3;
    if (matrix->type() == CV_32F && !(rotation_error(*pose) < kNoticeable))
      settings_.warn_at(key, Code::kOrbslamSomeQuaternion);
    view_.poses.push_back({std::move(a), std::move(b), *pose});
  }

  void read_image_info() {
    height_ = settings_.integer("Camera.height");
    width_ = settings_.integer("Camera.width");
    const bool new_height = settings_.has("Camera.newHeight");
    const bool new_width = settings_.has("Camera.newWidth");
    const int height = settings_.integer("Camera.newHeight", false);
    const int width = settings_.integer("Camera.newWidth", false);
    settings_.integer("Camera.fps");
    settings_.integer("Camera.RGB");
    if (!new_height && !new_width) return;
    if (is_remapped()) return settings_.warn_from("Camera.newWidth", Code::kOrbslamNewSizeRectified);
    if (new_height) rescale(scale_y_, height_, height);
    if (new_width) rescale(scale_x_, width_, width);
    warn_of_half_pixel();
  }

  static void rescale(float& scale, int& size, int new_size) {
    scale = static_cast<float>(new_size) / static_cast<float>(size);
    size = new_size;
  }

  /// System.cc resizes the images with cv::resize.
  void warn_of_half_pixel() {
    const double shift = 0.5 * std::max(std::abs(1.0 - scale_x_), std::abs(1.0 - scale_y_));
    if (!(shift > 0.0 && std::isfinite(shift))) return;
    settings_.warn_from("Camera.newWidth", Code::kOrbslamHalfPixelOff, {shift});
  }

  void read_imu() {
    view_.imu = read_noise(settings_);
    view_.imu->rate_hz = settings_.real("IMU.Frequency");
    read_pose("IMU.T_b_c1", "imu0", "cam0");
    settings_.integer("IMU.InsertKFsWhenLost", false);
  }

  void read_rgbd() {
    settings_.real("RGBD.DepthMapFactor");
    settings_.real("Stereo.ThDepth");
    view_.baseline_m = settings_.real("Stereo.b");
    const bool bent = std::any_of(first_.pinhole.begin(), first_.pinhole.end(), [](float value) { return value != 0.0F; });
    if (bent) settings_.warn_at("Camera1.k1", Code::kOrbslamDepthNotUndistorted);
    first_.misread = bent;
    first_.pinhole = {};
    if (!is_fisheye()) return;
    // Frame.cc, UnprojectStereo: (u - cx) z / fx, whatever Camera.type says; only mono and stereo ask the camera's class.
    settings_.warn(Code::kOrbslamDepthByPinhole);
    first_.misread = true;
    pinhole_depth_ = true;
  }

  void read_strict_lists() {
    for (const std::string_view key : kOrbIntKeys) settings_.integer(key);
    settings_.real("ORBextractor.scaleFactor");
    for (const std::string_view key : kViewerKeys) settings_.real(key);
  }

  void read_optional() {
    settings_.real("Viewer.imageViewScale", false);
    settings_.text("System.LoadAtlasFromFile", false);
    settings_.text("System.SaveAtlasToFile", false);
    settings_.real("System.thFarPoints", false);
  }

  /// Frame::UndistortKeyPoints returns at once if k1 is 0 (the mono sensors; stereo goes through maps).
  void ignore_distortion_without_k1() {
    if (!is_pinhole() || sensor_.stereo || first_.pinhole.front() != 0.0F) return;
    const bool bent = std::any_of(first_.pinhole.begin(), first_.pinhole.end(), [](float value) { return value != 0.0F; });
    if (bent) settings_.warn_at("Camera1.k1", Code::kOrbslamSkipsUndistortion, {settings_.program()});
    first_.misread = first_.misread || bent;
    first_.pinhole = {};
  }

  [[nodiscard]] ConsumerCamera to_camera(std::string name, const Camera& camera) const {
    const Intrinsics k = {camera.k.fx * scale_x_, camera.k.fy * scale_y_, camera.k.cx * scale_x_, camera.k.cy * scale_y_};
    const bool bends = is_fisheye() && !pinhole_depth_;
    Projection project = bends ? kannala_brandt8(k, camera.radial) : pinhole(k, camera.pinhole);
    ConsumerCamera result = {std::move(name), width_, height_, std::move(project), {scale_x_, scale_y_}, camera.misread};
    if (bends) {
      result.unproject = kannala_brandt8_rays(k, camera.radial);
      result.unproject_fault = {Code::kRaysUpToNinety};
    } else if (!sensor_.stereo && !pinhole_depth_) {  // stereo goes through maps
      result.unproject = pinhole_rays(k, camera.pinhole);
      result.unproject_fault = {Code::kRaysInFiveSteps};
    }
    result.model = type_;
    return result;
  }

  void add_cameras() {
    ignore_distortion_without_k1();
    view_.cameras.push_back(to_camera("cam0", first_));
    if (!sensor_.stereo) return;
    view_.cameras.push_back(to_camera("cam1", is_rectified() ? first_ : second_));
    if (is_rectified()) view_.poses.push_back(rectified_baseline(baseline_));
  }

  Settings& settings_;
  const Sensor& sensor_;
  ConsumerView& view_;
  std::string type_;
  Camera first_;
  Camera second_;
  double baseline_ = 0.0;
  bool pinhole_depth_ = false;
  int width_ = 0;
  int height_ = 0;
  float scale_x_ = 1.0F;
  float scale_y_ = 1.0F;
};

}  // namespace

void load_v1(Settings& settings, const Sensor& sensor, ConsumerView& view) { Parser(settings, sensor, view).run(); }

}  // namespace fca::consumers::orbslam
