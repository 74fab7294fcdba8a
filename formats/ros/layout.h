// SPDX-License-Identifier: BSD-3-Clause
// How ROS's names and numbers and ours map onto each other.
#pragma once

#include <fca/formats/opencv_coefficients.h>
#include <fca/formats/text/dialect.h>
#include <fca/rig/image_change.h>
#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::ros {

/// yaml-cpp looks a key up from the front: of equal ones the first counts, as in cv::FileStorage.
inline constexpr text::Dialect kDialect = text::Dialect::kOpenCv;

inline constexpr std::string_view kMatrix = "camera_matrix";
inline constexpr std::string_view kModel = "distortion_model";
inline constexpr std::string_view kCoefficients = "distortion_coefficients";
inline constexpr std::string_view kRectification = "rectification_matrix";
inline constexpr std::string_view kProjection = "projection_matrix";
inline constexpr std::array<std::string_view, 3> kReductionKeys = {"binning_x", "binning_y", "roi"};

using Matrix3 = std::array<double, 9>;      ///< Row-major.
using Projection = std::array<double, 12>;  ///< P, row-major.

inline constexpr Matrix3 kIdentity = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// Ours for a distortion_model that image_geometry knows; empty for any other.
[[nodiscard]] std::string_view model_of(std::string_view distortion_model);
/// The distortion_model of one of ours; empty if there is none.
[[nodiscard]] std::string_view name_of(const CameraModel& model);

/// The coefficients of a model in ROS's order; zeros of a pinhole.
[[nodiscard]] std::vector<double> coefficients_of(const CameraModel& model);

[[nodiscard]] Matrix3 camera_matrix_of(const CameraModel& model);

/// Which pixels of the sensor's image are published: column u of the sensor is (u - x) / binning_x.
struct Reduction {
  int binning_x = 1;
  int binning_y = 1;
  int x = 0;
  int y = 0;
  [[nodiscard]] bool changes_pixels() const { return binning_x != 1 || binning_y != 1 || x != 0 || y != 0; }
  [[nodiscard]] PixelMap map() const;
};

/// The camera of the whole sensor's image, of one whose pixels are the published ones.
[[nodiscard]] CameraModel unreduced(const CameraModel& model, const Reduction& reduction);

/// The frame in which P specifies a camera's place. A pair has one: StereoCameraModel asserts that fx', fy' and cy' of both are
/// equal.
[[nodiscard]] std::string frame_of(const Projection& P);
[[nodiscard]] bool is_rectified_frame(std::string_view frame);

/// T_rectified_camera, as R and P specify it.
[[nodiscard]] Transform pose_of(const Matrix3& R, const Projection& P);

/// Of a camera that is rectified as it is: [K | 0].
[[nodiscard]] Projection projection_of(const Matrix3& K);

}  // namespace fca::ros
