// SPDX-License-Identifier: BSD-3-Clause
// stella_vslam's configuration (stella-cv/stella_vslam@b0e60d6 of 2025-07: camera/*.cc, util/stereo_rectifier.cc), read with
// yaml-cpp.
//
//   Camera
//     name, setup         any text; monocular, stereo or RGBD
//     model               perspective (fx fy cx cy k1 k2 p1 p2 k3: OpenCV's), fisheye (k1 k2 k3 k4: cv::fisheye's),
//                         radial_division (distortion: a pixel's ray is (x, y, 1 + distortion r^2)), equirectangular
//                         (cols and rows alone: a table of rays here, which is kept where its file is edited)
//     fps, cols, rows
//     focal_x_baseline    fx [px] times the distance [m] of a rectified pair, or of a depth sensor's virtual second camera
//     depth_threshold, color_order (Gray, RGB, BGR)   may be missing
//   StereoRectifier       of a pair that is not rectified: Camera is then what both are rectified to (P of cv::stereoRectify)
//     model               perspective, if it is missing, or fisheye
//     K_left, D_left, R_left, K_right, D_right, R_right   rows of matrices one after the other: p_rectified = R p_camera
//
// All other keys tune the program, and may be missing. OpenVSLAM, of which stella_vslam is a fork, read the same keys with a
// point between their levels ("Camera.fx") until 2021, and called radial_division division_undistortion for a few weeks.
#pragma once

#include "../ros/rectification.h"

#include <fca/formats/text/dialect.h>
#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::stella {

/// yaml-cpp looks a key up from the front: of equal ones the first counts, as in cv::FileStorage.
inline constexpr text::Dialect kDialect = text::Dialect::kOpenCv;

inline constexpr std::string_view kProgram = "stella_vslam";
/// Layouts of a fresh file, by the program: nested, dotted.
inline constexpr std::string_view kStellaVslam = "stella_vslam";
inline constexpr std::string_view kOpenVslam = "openvslam";
inline constexpr std::string_view kCamera = "Camera";
inline constexpr std::string_view kRectifier = "StereoRectifier";

/// A model without numbers.
inline constexpr std::string_view kPanorama = "equirectangular";

inline constexpr std::string_view kStereo = "stereo";
inline constexpr std::string_view kDepth = "RGBD";

/// Keys of Camera that a rig has no member for, as extra fields.
inline constexpr std::string_view kName = "Camera.name";
inline constexpr std::string_view kSetup = "Camera.setup";
inline constexpr std::string_view kColourOrder = "Camera.color_order";
inline constexpr std::string_view kDepthThreshold = "Camera.depth_threshold";
/// What stands before the names of the program's other blocks there.
inline constexpr std::string_view kTuning = "stella.";

/// How the keys of a block are written.
enum class Style {
  kNested,  ///< Camera: with fx below it.
  kDotted,  ///< Camera.fx:
};
[[nodiscard]] Style style_of(const text::Document& document);

/// A key of a block, in either style; null if it is not there.
[[nodiscard]] const text::Node* find_key(const text::Document& document, std::string_view block, std::string_view key);

/// A number of a lens: its key and ours.
struct Coefficient {
  std::string_view key;
  ParameterId parameter;
};

/// A lens under the program's name; fx fy cx cy have the same names as ours.
struct Lens {
  std::string_view name;
  std::string_view model;
  std::span<const Coefficient> coefficients;
};
/// Null for a name that the program does not know.
[[nodiscard]] const Lens* find_lens(std::string_view name);
/// Under which name a model is written: a pinhole as a lens with zeros. Null if there is none.
[[nodiscard]] const Lens* lens_of(const CameraModel& model);
/// Those that are read, and that StereoRectifier takes.
[[nodiscard]] std::vector<std::string> lens_names();
[[nodiscard]] bool may_be_rectified(const Lens& lens);

/// The coefficients of a pair's lens in the order of its list D; zeros of a pinhole.
[[nodiscard]] std::vector<double> coefficients_of(const CameraModel& model);

/// How the first two cameras are rectified: as their file specifies it, where StereoRectifier can say that, else computed.
[[nodiscard]] ros::Rectification rectification_of(const Rig& rig);
/// fx [px] times the distance [m] of the second camera, which stands to the right of the first; else not above 0.
[[nodiscard]] double focal_times_baseline(const ros::Rectification& rectification);

/// Stand the first two cameras so that they can be rectified, whatever their lenses are? Else `why_not`: a clause for people.
[[nodiscard]] bool stands_as_pair(const Rig& rig, std::vector<Message>& why_not);

/// Has the rig the two cameras of one pair that StereoRectifier takes? Else `why_not`: a clause for people, if it has two.
[[nodiscard]] bool is_pair(const Rig& rig, std::vector<Message>& why_not);

}  // namespace fca::stella
