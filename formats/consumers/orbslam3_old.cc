// SPDX-License-Identifier: BSD-3-Clause
// ORB-SLAM3's parser of files without `File.version: "1.0"`: src/Tracking.cc (ParseCamParamFile, ParseORBParamFile,
// ParseIMUParamFile), src/MapDrawer.cc, src/Viewer.cc; and the fork urbste/ORB_SLAM3 (feature/gopro_slam), which adds the
// double sphere model to an earlier state of the same parser.
#include <algorithm>
#include <cmath>

#include "orbslam_shared.h"
#include "programs.h"

namespace fca::consumers {
namespace orbslam {
namespace {

constexpr std::array<std::string_view, 4> kPinholeKeys = {"Camera.k1", "Camera.k2", "Camera.p1", "Camera.p2"};
constexpr std::array<std::string_view, 4> kRadialNames = {"k1", "k2", "k3", "k4"};

/// A camera's formula; the other direction where it is known to go wrong, and how.
struct Lens {
  Projection project;
  Unprojection unproject = {};
  Code fault = {};
};

class Parser {
 public:
  Parser(Settings& settings, const Sensor& sensor, const OldDialect& dialect, ConsumerView& view)
      : settings_(settings), sensor_(sensor), dialect_(dialect), view_(view) {}

  void run() {
    type_ = read_type();
    width_ = read_size("Camera.width");
    height_ = read_size("Camera.height");
    read_scale();
    if (type_ == "PinHole") read_pinhole();
    if (type_ == "KannalaBrandt8") read_fisheye(&Parser::read_kannala_brandt8);
    if (type_ == "DoubleSphere") read_fisheye(&Parser::read_double_sphere);
    read_depth();
    read_orb();
    if (sensor_.inertial) read_imu();
    read_viewer();
  }

 private:
  [[nodiscard]] bool is_supported(const std::string& type) const {
    return type == "PinHole" || type == "KannalaBrandt8" || (type == "DoubleSphere" && dialect_.knows_double_sphere);
  }

  std::string read_type() {
    const cv::FileNode node = settings_.node("Camera.type");
    const std::string type = node.isString() ? node.string() : std::string();
    if (is_supported(type)) return type;
    std::vector<std::string> known = {"PinHole", "KannalaBrandt8"};
    if (dialect_.knows_double_sphere) known.emplace_back("DoubleSphere");
    std::vector<Message> hint;
    if (settings_.has("Camera1.fx")) hint = {{Code::kOrbslamKeysOfV1}};
    if (node.empty()) {
      settings_.refuse_at("Camera.type", Code::kOrbslamOldTypeMissing, {settings_.program(), known, hint});
    } else {
      settings_.refuse_at("Camera.type", Code::kOrbslamOldType, {description_of(node), settings_.program(), known, hint});
    }
    return {};
  }

  /// Only the viewer reads the size, with any number type.
  int read_size(std::string_view key) {
    const cv::FileNode node = settings_.node(key);
    if (!node.empty()) return static_cast<int>(std::lround(std::min(std::abs(settings_.loose(key)), 1e6F)));
    settings_.refuse_at(key, Code::kOrbslamViewerStops, {settings_.program()});
    return 0;
  }

  void read_scale() {
    const cv::FileNode node = settings_.node("Camera.imageScale");
    if (!dialect_.scales_image || !node.isReal()) return;
    scale_ = static_cast<float>(node.real());
    width_ = static_cast<int>(static_cast<float>(width_) * scale_);
    height_ = static_cast<int>(static_cast<float>(height_) * scale_);
  }

  Intrinsics read_intrinsics(const std::string& camera) {
    return {settings_.real(camera + ".fx") * scale_, settings_.real(camera + ".fy") * scale_,
            settings_.real(camera + ".cx") * scale_, settings_.real(camera + ".cy") * scale_};
  }

  void add_camera(std::string name, Lens lens) {
    view_.cameras.push_back({std::move(name), width_, height_, std::move(lens.project), {scale_, scale_}});
    view_.cameras.back().unproject = std::move(lens.unproject);
    view_.cameras.back().unproject_fault = {lens.fault};
    view_.cameras.back().model = type_;
  }

  void read_pinhole() {
    const Intrinsics k = read_intrinsics("Camera");
    PinholeDistortion distortion{};
    for (std::size_t i = 0; i < kPinholeKeys.size(); ++i) distortion.at(i) = settings_.real(kPinholeKeys.at(i));
    const cv::FileNode k3 = settings_.node("Camera.k3");
    if (k3.isReal()) distortion.back() = static_cast<float>(k3.real());
    if (k3.isInt()) settings_.warn_at("Camera.k3", Code::kOrbslamK3IsInt, {settings_.program()});
    drop_distortion_without_k1(distortion);
    add_camera("cam0", sensor_.stereo ? Lens{pinhole(k, distortion)}
                                      : Lens{pinhole(k, distortion), pinhole_rays(k, distortion), Code::kRaysInFiveSteps});
    const float baseline = k.fx != 0.0F ? settings_.loose("Camera.bf") * scale_ / k.fx : 0.0F;
    if (sensor_.rgbd) view_.baseline_m = baseline;
    if (!sensor_.stereo) return;
    add_camera("cam1", {pinhole(k, distortion)});  // the images are taken as rectified
    if (k.fx != 0.0F) view_.poses.push_back(rectified_baseline(baseline));
    if (settings_.has("RIGHT.K")) settings_.warn(Code::kOrbslamRectifiedElsewhere);
  }

  /// Frame::UndistortKeyPoints returns at once if k1 is 0.
  void drop_distortion_without_k1(PinholeDistortion& distortion) {
    if (distortion.front() != 0.0F) return;
    const bool bent = std::any_of(distortion.begin(), distortion.end(), [](float value) { return value != 0.0F; });
    if (bent) settings_.warn_at("Camera.k1", Code::kOrbslamSkipsUndistortion, {settings_.program()});
    distortion = {};
  }

  Lens read_kannala_brandt8(const std::string& camera) {
    const Intrinsics k = read_intrinsics(camera);
    std::array<float, 4> radial{};
    for (std::size_t i = 0; i < radial.size(); ++i)
      radial.at(i) = settings_.real(camera + "." + std::string(kRadialNames.at(i)));
    return {kannala_brandt8(k, radial), kannala_brandt8_rays(k, radial), Code::kRaysUpToNinety};
  }

  Lens read_double_sphere(const std::string& camera) {
    const Intrinsics k = read_intrinsics(camera);
    const float xi = settings_.real(camera + ".xi");
    return {double_sphere(k, xi, settings_.real(camera + ".alpha"))};
  }

  void read_fisheye(Lens (Parser::*read)(const std::string&)) {
    add_camera("cam0", (this->*read)("Camera"));
    const bool rgbd_inertial =
        sensor_.rgbd && sensor_.inertial && dialect_.rgbd_needs_bf;  // V1.0 reads a second camera there too
    if (!sensor_.stereo && !rgbd_inertial) return;
    add_camera("cam1", (this->*read)("Camera2"));
    read_left_right_pose();
    for (const std::string_view key :
         {"Camera.lappingBegin", "Camera.lappingEnd", "Camera2.lappingBegin", "Camera2.lappingEnd"}) {
      if (!settings_.node(key).isInt()) settings_.warn_at(key, Code::kOrbslamLappingNotInt, {settings_.program()});
    }
  }

  void read_left_right_pose() {
    const std::optional<cv::Mat> matrix = settings_.matrix("Tlr");
    if (!matrix) return;
    const auto pose = rows_as_float(*matrix);
    if (matrix->rows != 3 || matrix->cols != 4 || !pose) {
      settings_.refuse_at("Tlr", Code::kOrbslamPairSize, {matrix->rows, matrix->cols, settings_.program()});
      return;
    }
    warn_unless_float(settings_, "Tlr", *matrix);
    view_.poses.push_back({"cam0", "cam1", *pose});
  }

  void read_depth() {
    if (sensor_.stereo || (sensor_.rgbd && dialect_.rgbd_needs_bf)) settings_.real("Camera.bf");
    if (sensor_.stereo || sensor_.rgbd) settings_.real("ThDepth");
    if (sensor_.rgbd) settings_.real("DepthMapFactor");
  }

  void read_orb() {
    for (const std::string_view key : kOrbIntKeys) settings_.integer(key);
    settings_.real("ORBextractor.scaleFactor");
  }

  void read_imu() {
    const int rate = settings_.integer("IMU.Frequency");
    view_.imu = read_noise(settings_);
    view_.imu->rate_hz = rate;
    const std::optional<cv::Mat> matrix = settings_.matrix("Tbc");
    if (!matrix) return;
    const auto pose = pointer_as_float(*matrix);
    if (matrix->rows != 4 || matrix->cols != 4 || !pose) {
      settings_.refuse_at("Tbc", Code::kOrbslamImuSize, {matrix->rows, matrix->cols, settings_.program()});
      return;
    }
    warn_unless_float(settings_, "Tbc", *matrix);
    check_rotation(*pose);
    view_.poses.push_back({"imu0", "cam0", *pose});
  }

  /// Sophus::SO3f(R) aborts the process ("R is not orthogonal", UZ-SLAMLab/ORB_SLAM3 issue 598).
  void check_rotation(const std::array<double, 16>& pose) {
    constexpr double kSophusEpsilon = 1e-5;
    const double error = rotation_error(pose);
    if (!dialect_.checks_rotation || error < kSophusEpsilon) return;
    settings_.refuse_at("Tbc", Code::kOrbslamSophusAborts, {error, settings_.program()});
  }

  void read_viewer() {
    for (const std::string_view key : kViewerKeys) {
      if (settings_.has(key)) continue;
      settings_.refuse_at(key, Code::kOrbslamViewerStops, {settings_.program()});
    }
  }

  Settings& settings_;
  const Sensor& sensor_;
  const OldDialect& dialect_;
  ConsumerView& view_;
  std::string type_;
  int width_ = 0;
  int height_ = 0;
  float scale_ = 1.0F;
};

/// src/System.cc: the new parser runs only if File.version is a *string* and equals "1.0".
bool is_v1(Settings& settings) {
  const cv::FileNode version = settings.node("File.version");
  if (version.empty()) return false;
  if (version.isString() && version.string() == "1.0") return true;
  settings.warn_at("File.version", Code::kOrbslamVersionNotText, {description_of(version)});
  return false;
}

}  // namespace

void load_old(Settings& settings, const Sensor& sensor, const OldDialect& dialect, ConsumerView& view) {
  Parser(settings, sensor, dialect, view).run();
}

}  // namespace orbslam

ConsumerView load_orbslam3(std::string_view bytes, const LoadOptions& options) {
  constexpr orbslam::OldDialect kDialect = {
      .knows_double_sphere = false, .checks_rotation = true, .rgbd_needs_bf = true, .scales_image = true};
  const auto read = [&kDialect](orbslam::Settings& settings, const orbslam::Sensor& sensor, ConsumerView& view) {
    if (orbslam::is_v1(settings)) {
      orbslam::load_v1(settings, sensor, view);
    } else {
      orbslam::load_old(settings, sensor, kDialect, view);
    }
  };
  return orbslam::with_settings(bytes, "ORB-SLAM3 V1.0", options, read);
}

ConsumerView load_urbste(std::string_view bytes, const LoadOptions& options) {
  constexpr orbslam::OldDialect kDialect = {
      .knows_double_sphere = true, .checks_rotation = false, .rgbd_needs_bf = false, .scales_image = false};
  const auto read = [&kDialect](orbslam::Settings& settings, const orbslam::Sensor& sensor, ConsumerView& view) {
    orbslam::load_old(settings, sensor, kDialect, view);
  };
  return orbslam::with_settings(bytes, "urbste/ORB_SLAM3", options, read);
}

}  // namespace fca::consumers
