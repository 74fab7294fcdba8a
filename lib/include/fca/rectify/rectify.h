// SPDX-License-Identifier: BSD-3-Clause
// Stereo rectification: how two cameras are turned, and which pinhole camera both become, so that what one sees in a row the
// other sees in the same row (in the same column, where one camera stands above the other).
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <array>
#include <optional>
#include <variant>

namespace fca {

/// The widest view that is rectified: at its border a pinhole image is stretched four times.
inline constexpr double kWidestRectifiedView = 2.0943951023931953;  // 120 deg

/// R1, R2, and where the second camera stands in the frame that they turn to.
struct RectifyingRotations {
  std::array<Transform, 2> T_rectified_camera;  ///< Rotations.
  bool is_vertical = false;
  double offset_m = 0.0;  ///< Of the second camera: to the right (below, where vertical); negative: to the left (above).
};

/// J.-Y. Bouguet's, as cv::stereoRectify has them: each camera is turned by half the rotation between them, then both so that
/// the baseline lies along the rows, or the columns where it is nearer to these. The rotation is the one nearest to the pose's.
/// Nothing where the cameras stand at the same place, or the pose has no rotation.
[[nodiscard]] std::optional<RectifyingRotations> rectifying_rotations(const Transform& T_second_first);

/// What both cameras are to become.
struct RectifiedByAlpha {
  double alpha = 0.0;  ///< 0: all pixels are seen by both cameras; 1: all that both see is in the image. As OpenCV's.
};
struct RectifiedByField {
  double full_fov_rad = 0.0;  ///< Across the width, the axis in the middle; in (0, 120 deg].
};
/// std::monostate: alpha 0 where both lenses are narrower than 120 deg across, else as fine as the middle of the finer image,
/// up to 120 deg wide.
using RectifiedViewChoice = std::variant<std::monostate, RectifiedByAlpha, RectifiedByField>;

struct RectifyOptions {
  RectifiedViewChoice view;
  std::optional<ImageSize> size = {};  ///< Of the rectified images; nothing: as the cameras'.
  bool valid_regions = true;           ///< They are wanted; else a pair without any is none the worse.
};

/// The rectified pair of two cameras with images of one size. The common camera is made as cv::stereoRectify makes it with
/// CALIB_ZERO_DISPARITY, from corners and borders that are undistorted exactly. Nothing with an error where there is none.
[[nodiscard]] std::optional<RectifiedPair> rectify(const Camera& first, const Camera& second, const Transform& T_second_first,
                                                   const RectifyOptions& options, Diagnostics& diagnostics);

/// The rectified camera of a view, 0 or 1: a pinhole of that size.
[[nodiscard]] Camera rectified_camera(const RectifiedPair& pair, std::size_t view, const ImageSize& size);

/// T_second_first, as the rectification specifies it.
[[nodiscard]] Transform pose_of(const RectifiedPair& pair);

/// Is Rig::rectified of two cameras of the rig, and says of their pose what its poses say, to 1e-5 (an element of the rotation,
/// metres)?
[[nodiscard]] bool states_rectification(const Rig& rig);

/// The same pair with its views exchanged.
[[nodiscard]] RectifiedPair exchanged(const RectifiedPair& pair);

/// The part of the rectified image whose pixels `camera` sees, each of them: a rectangle that is shrunk from the whole image
/// where its border is seen least. Nothing where none is left.
[[nodiscard]] std::optional<ImageRegion> valid_region(const Camera& camera, const RectifiedPair& pair, std::size_t view,
                                                      const ImageSize& size);

}  // namespace fca
