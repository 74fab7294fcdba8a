// SPDX-License-Identifier: BSD-3-Clause
// What is left of the epipolar error after a rectification.
#pragma once

#include <fca/rectify/rectify.h>

#include <algorithm>
#include <optional>
#include <string>

namespace fca {

/// A camera as its images are, and as those take it to be who rectify them: a converted model, or a program's misreading.
struct MeantCamera {
  Camera source;  ///< With an image size.
  CameraModel meant;
};

/// By how many rows the two images of a point differ (columns, of a vertical pair), over what both rectified images show.
struct RowDifference {
  double rms_px = 0.0;
  double max_px = 0.0;  ///< Largest magnitude.
  Pixel max_at{};       ///< In the first rectified image.
  double share = 0.0;   ///< Of the lattice over the first rectified image: how much both see.
};

/// Where near points are looked at, from the first camera [baselines].
inline constexpr double kNearPoints = 10.0;

struct VerticalDisparity {
  RowDifference at_infinity;
  RowDifference at_ten_baselines;  ///< Points ten baselines away from the first camera.
};

/// `T_second_first`: where the cameras are; the rectification may say otherwise. A ray of the first source camera is followed
/// to the second one's pixel, and both pixels are taken to rows by what is meant and the pair's rotations. Nothing where
/// nothing is seen by both.
[[nodiscard]] std::optional<VerticalDisparity> vertical_disparity(const MeantCamera& first, const MeantCamera& second,
                                                                  const Transform& T_second_first, const RectifiedPair& pair,
                                                                  const ImageSize& size);

/// What stereo feels of a pair that is written otherwise than it is.
struct PairError {
  std::string first;  ///< Names of the cameras.
  std::string second;
  VerticalDisparity disparity;

  /// The larger of those far away and at ten baselines.
  [[nodiscard]] double rms_px() const { return std::max(disparity.at_infinity.rms_px, disparity.at_ten_baselines.rms_px); }
  [[nodiscard]] double max_px() const { return std::max(disparity.at_infinity.max_px, disparity.at_ten_baselines.max_px); }
};

/// The disparity across the rows of images that are rectified by what is meant: the lenses and the pose `T_meant`. Nothing
/// where those cannot be rectified.
[[nodiscard]] std::optional<PairError> pair_error(const MeantCamera& first, const MeantCamera& second,
                                                  const Transform& T_second_first, const Transform& T_meant);

}  // namespace fca
