// SPDX-License-Identifier: BSD-3-Clause
// ROS's camera_info: what camera_calibration writes (ost.yaml, left.yaml), camera_info_manager loads through
// camera_calibration_parsers (ros-perception/image_common, parse_yml.cpp) and image_geometry (vision_opencv,
// pinhole_camera_model.cpp, stereo_camera_model.cpp) computes with. One camera per file.
//
//   image_width, image_height    of the whole sensor, ints; camera_name
//   camera_matrix                {rows: 3, cols: 3, data}: K of the image as it comes
//   distortion_model             plumb_bob, rational_polynomial (cv::projectPoints), equidistant (cv::fisheye)
//   distortion_coefficients      {rows: 1, cols, data}: k1 k2 p1 p2 [k3 [k4 k5 k6]]; of equidistant k1 .. k4
//   rectification_matrix         {rows: 3, cols: 3, data}: R, p_rectified = R p_camera (directions)
//   projection_matrix            {rows: 3, cols: 4, data}: P of the rectified image; P(0, 3) = -fx' x, P(1, 3) = -fy' y, where
//   x, y
//                                is this camera's centre [m] in the rectified frame, whose origin is the first camera of a pair
//   binning_x, binning_y, roi    (read since image_common 4.1 and Noetic) the images are a part of the sensor's: u' = (u - x) /
//   bin
//
// R and P of one file specify T_rectified_camera = [R | x y 0]; a pair shares the frame, and with it fx', fy' and cy' of P.
#pragma once

#include <fca/formats/format.h>

namespace fca::ros {

extern const Format kFormat;

/// The camera of the whole sensor, of one of its binned images or a part of them.
[[nodiscard]] std::optional<Camera> as_stated(const text::Document& document, const Camera& camera);

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::ros
