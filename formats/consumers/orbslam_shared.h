// SPDX-License-Identifier: BSD-3-Clause
// Private: what the consumers of the ORB-SLAM family have in common. cv::FileStorage reads their files, as it does for them.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fca/code.h"
#include "fca/formats/consumers/consumer.h"
#include "storage.h"

namespace fca::consumers::orbslam {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Projection = std::function<std::optional<Pixel>(const Ray&)>;
using Unprojection = std::function<std::optional<Ray>(const Pixel&)>;

/// LoadOptions::sensor taken apart.
struct Sensor {
  bool stereo = false;
  bool rgbd = false;
  bool inertial = false;
};
[[nodiscard]] std::optional<Sensor> parse_sensor(std::string_view name);

/// Pinhole intrinsics as ORB-SLAM keeps them: 24 bits.
struct Intrinsics {
  float fx = 0.0F, fy = 0.0F, cx = 0.0F, cy = 0.0F;
};

/// k1 k2 p1 p2 k3, as OpenCV orders them.
using PinholeDistortion = std::array<float, 5>;

[[nodiscard]] Projection pinhole(const Intrinsics& k, const PinholeDistortion& distortion);
/// Frame::UndistortKeyPoints, of the modes that call it.
[[nodiscard]] Unprojection pinhole_rays(const Intrinsics& k, const PinholeDistortion& distortion);
[[nodiscard]] Projection kannala_brandt8(const Intrinsics& k, const std::array<float, 4>& coeffs);
/// Of ORB-SLAM3: right only for rays in front of the camera.
[[nodiscard]] Unprojection kannala_brandt8_rays(const Intrinsics& k, const std::array<float, 4>& coeffs);
[[nodiscard]] Projection double_sphere(const Intrinsics& k, float xi, float alpha);
[[nodiscard]] Projection eucm(const Intrinsics& k, float alpha, float beta);

using storage::description_of;

/// A settings file that is open in cv::FileStorage, and what is said of it.
class Settings {
 public:
  Settings(const cv::FileStorage& storage, std::string_view program, ConsumerView& view)
      : storage_(storage), program_(program), view_(view) {}

  /// Of the file as a whole.
  void refuse(Code code, std::vector<Argument> arguments = {}) { view_.refusals.emplace_back(code, "", std::move(arguments)); }
  void warn(Code code, std::vector<Argument> arguments = {}) { view_.warnings.emplace_back(code, "", std::move(arguments)); }
  /// Of what stands under the key: argument 0, `more` follow.
  void refuse_at(std::string_view key, Code code, std::vector<Argument> more = {}) {
    more.insert(more.begin(), key);
    view_.refusals.emplace_back(code, std::string(key), std::move(more));
  }
  void warn_at(std::string_view key, Code code, std::vector<Argument> more = {}) {
    more.insert(more.begin(), key);
    view_.warnings.emplace_back(code, std::string(key), std::move(more));
  }
  /// Of several keys, of which this is the first.
  void warn_from(std::string_view key, Code code, std::vector<Argument> more = {}) {
    warn_at(key, code, std::move(more));
    view_.warnings.back().key += '/';
  }
  void last_warning_costs_pixels() { view_.warnings.back().costs_pixels = true; }
  [[nodiscard]] const std::string& program() const { return program_; }
  [[nodiscard]] cv::FileNode node(std::string_view key) const { return storage_[std::string(key)]; }
  [[nodiscard]] bool has(std::string_view key) const { return !node(key).empty(); }

  /// Must be a number with '.' or exponent; refuses anything else. Missing is refused only if `required`.
  float real(std::string_view key, bool required = true);
  /// Must be an int.
  int integer(std::string_view key, bool required = true);
  /// Must be a string.
  std::string text(std::string_view key, bool required = true);
  /// cv::FileNode's implicit conversion, missing = 0 (ORB-SLAM2's way).
  float loose(std::string_view key);
  /// A matrix node, or nothing with a refusal.
  std::optional<cv::Mat> matrix(std::string_view key);

 private:
  void refuse_missing(std::string_view key);

  cv::FileStorage storage_;
  std::string program_;
  ConsumerView& view_;
};

/// Runs `body` on the file opened in cv::FileStorage, behind limits that keep OpenCV's parser off the end of the stack. Turns
/// what OpenCV throws into a refusal, and clears cameras and poses of a refused file.
[[nodiscard]] ConsumerView with_settings(std::string_view bytes, std::string_view program, const LoadOptions& options,
                                         const std::function<void(Settings&, const Sensor&, ConsumerView&)>& body);

/// Rows 0..2 read as the programs do it, with .at<float>(r, c) whatever the element type is: garbage for dt: d. Last row 0 0
/// 0 1.
[[nodiscard]] std::optional<std::array<double, 16>> rows_as_float(const cv::Mat& matrix);
/// Sixteen floats through a raw pointer to the first element.
[[nodiscard]] std::optional<std::array<double, 16>> pointer_as_float(const cv::Mat& matrix);
/// Frobenius norm of R R^T - I.
[[nodiscard]] double rotation_error(const std::array<double, 16>& pose);
/// Warns if a matrix that is read as float is not float.
void warn_unless_float(Settings& settings, std::string_view key, const cv::Mat& matrix);

/// IMU.NoiseGyro, NoiseAcc, GyroWalk, AccWalk, which both parsers of ORB-SLAM3 demand.
[[nodiscard]] ConsumerImu read_noise(Settings& settings);

/// T_cam0_cam1 of rectified cameras: only a shift along x.
[[nodiscard]] ConsumerPose rectified_baseline(double baseline);

// Keys both parsers of ORB-SLAM3 demand.
inline constexpr std::array<std::string_view, 10> kViewerKeys = {
    "Viewer.KeyFrameSize",    "Viewer.KeyFrameLineWidth", "Viewer.GraphLineWidth", "Viewer.PointSize",  "Viewer.CameraSize",
    "Viewer.CameraLineWidth", "Viewer.ViewpointX",        "Viewer.ViewpointY",     "Viewer.ViewpointZ", "Viewer.ViewpointF"};
inline constexpr std::array<std::string_view, 4> kOrbIntKeys = {"ORBextractor.nFeatures", "ORBextractor.nLevels",
                                                                "ORBextractor.iniThFAST", "ORBextractor.minThFAST"};

// The two parsers of ORB-SLAM3, and what the old one does differently in a fork.
void load_v1(Settings& settings, const Sensor& sensor, ConsumerView& view);

struct OldDialect {
  bool knows_double_sphere = false;
  bool checks_rotation = false;  ///< Tbc goes through Sophus, which aborts unless R R^T = I to 1e-5.
  bool rgbd_needs_bf = false;
  bool scales_image = false;  ///< Camera.imageScale exists.
};
void load_old(Settings& settings, const Sensor& sensor, const OldDialect& dialect, ConsumerView& view);

}  // namespace fca::consumers::orbslam
