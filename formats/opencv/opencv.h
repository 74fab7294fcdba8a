// SPDX-License-Identifier: BSD-3-Clause
// OpenCV: what programs around its calibration functions leave in cv::FileStorage's YAML, XML and JSON. There is no schema; key
// families seen (OpenCV's samples calibration.cpp, camera_calibration.cpp, stereo_calib.cpp; ccalib's omni_calibration.cpp and
// omni_stereo_calibration.cpp; MC-Calib; MATLAB exports):
//
//   one camera   camera_matrix (Camera_Matrix, K, ..), distortion_coefficients (dist_coeffs, D, ..), image_width, image_height,
//                fisheye_model 0/1; xi: cv::omnidir
//   a pair       the same names with 1/2, _left/_right, L/R: M1 D1 M2 D2, K1 D1 .., camera_matrix_left ..; R, T:
//                p_2 = R p_1 + T, metres if nothing else is said; or R and T alone, in a file of their own
//                R1 R2 P1 P2 Q: its rectification (cv::stereoRectify)
//   maps         camera_0, camera_1, .. with camera_matrix, distortion_vector, distortion_type 0/1, img_width, img_height,
//                camera_pose_matrix (camera -> reference of its camera_group)
//   MATLAB       IntrinsicMatrix1 (transposed), RadialDistortion1, TangentialDistortion1, RotationOfCamera2, ..
//
// Distortion: 0, 5, 8, 12 or 14 numbers are cv::projectPoints' (k1 k2 p1 p2 k3 k4 k5 k6 s1..s4 tau_x tau_y). Four are that or
// cv::fisheye's k1..k4: the file says which, or the caller.
#pragma once

#include <fca/formats/format.h>

namespace fca::opencv {

extern const Format kFormat;

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::opencv
