// SPDX-License-Identifier: BSD-3-Clause
// LEFT.* and RIGHT.* of ORB-SLAM2 (Examples/Stereo/stereo_euroc.cc) and of ORB-SLAM3 before V1.0: the cameras as they take the
// images (K, D, height, width) and their rectification (R, P), by which the program makes the images that Camera.* is of.
#pragma once

#include "../fields.h"

#include <fca/rig/rig.h>

#include <optional>
#include <vector>

namespace fca::orbslam3 {

/// Nothing where any of the keys is missing, or they are no rectified pair next to each other.
[[nodiscard]] std::optional<RectifiedPair> read_left_right(const text::Document& document);

/// The coefficients that cv::initUndistortRectifyMap takes for a camera: 5, 8, 12 or 14; nothing of a model that it has not.
[[nodiscard]] std::optional<std::vector<double>> coefficients_of(const CameraModel& model);

/// Of a pair whose `sources` are cameras with coefficients_of() and sizes.
[[nodiscard]] std::vector<fields::Field> left_right_fields(const RectifiedPair& pair);

}  // namespace fca::orbslam3
