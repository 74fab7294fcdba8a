// SPDX-License-Identifier: BSD-3-Clause
// Which keys hold what, per style of settings file and camera type.
#pragma once

#include <fca/formats/text/document.h>
#include <fca/models/camera_model.h>

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace fca::orbslam3 {

/// Whose settings file.
enum class Style {
  kV1,         ///< ORB-SLAM3 V1.0: File.version "1.0", Camera1.*, Stereo.*, IMU.T_b_c1
  kOld,        ///< ORB-SLAM3 before V1.0 and urbste's fork: Camera.type, Camera.*, Tlr, Tbc
  kOrbSlam2,   ///< No Camera.type
  kSlamNoOpt,  ///< ns15417/slam_no_opt: Camera.type EUCM or KB, RIGHT.K, RIGHT.D, CAMERA.R, CAMERA.T, Camera.Tbc
};

/// Styles by the names that WriteOptions::layout takes.
struct StyleName {
  std::string_view name;
  Style style;
};
inline constexpr std::string_view kCommonLens = "v1-common";  ///< V1.0's, for two fisheyes with one k1 to k4.
inline constexpr std::array kStyleNames = {StyleName{"v1", Style::kV1}, StyleName{kCommonLens, Style::kV1},
                                           StyleName{"old", Style::kOld}, StyleName{"orbslam2", Style::kOrbSlam2},
                                           StyleName{"slam_no_opt", Style::kSlamNoOpt}};
[[nodiscard]] constexpr std::optional<Style> style_named(std::string_view name) {
  for (const StyleName& each : kStyleNames) {
    if (each.name == name) return each.style;
  }
  return std::nullopt;
}

/// One key of a camera, after its prefix "Camera1.", and the parameter of our model it holds (or the constant it must be).
struct Slot {
  constexpr Slot(std::string_view name, ParameterId id, bool needed = true) : key(name), parameter(id), required(needed) {}
  constexpr Slot(std::string_view name, std::nullopt_t) : key(name), required(false) {}
  std::string_view key;
  std::optional<ParameterId> parameter;  ///< Nothing: 0.
  bool required = true;                  ///< false: absent means 0
};

/// How one style writes one of our models.
struct Layout {
  Style style;
  std::string_view type;  ///< Camera.type; "" where the style has none
  std::string_view model;
  std::vector<Slot> slots;
};

/// Does the program match a pair of such cameras in the images as they are, without rectifying them?
[[nodiscard]] bool is_fisheye(const Layout& layout);

/// Writing takes the first row of a style and model.
[[nodiscard]] const std::vector<Layout>& layouts();

/// The row for writing; null if the style cannot store the model.
[[nodiscard]] const Layout* find_layout(Style style, std::string_view model);

/// What a file's keys say about its style; see the .cc for the order of the tests.
[[nodiscard]] Style style_of(const text::Document& document);

/// "Camera1." or "Camera." for the first camera, "Camera2." for the second.
[[nodiscard]] std::string_view camera_prefix(Style style, std::size_t index);

/// Names of the keys that styles spell differently.
struct PoseKeys {
  std::string_view T_c1_c2;   ///< second camera in the first
  std::string_view T_imu_c1;  ///< first camera in the IMU
};
[[nodiscard]] PoseKeys pose_keys(Style style);

/// The key under which a document specifies the first camera in the IMU; "" if it does not.
[[nodiscard]] std::string_view imu_pose_key(const text::Document& document);

/// slam_no_opt's time offset, stated the other way round: t_image = t_imu + delay [s]. It stands in the fork's own files; no
/// other program of the family has a key for it.
inline constexpr std::string_view kDelayKey = "Camera.delaytoimu";

/// The value that counts under a top-level key, as cv::FileStorage looks it up; null if there is none.
[[nodiscard]] const text::Node* find_key(const text::Document& document, std::string_view key);

}  // namespace fca::orbslam3
