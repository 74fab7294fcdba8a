// SPDX-License-Identifier: BSD-3-Clause
// OpenVINS: kalibr_imucam_chain.yaml and kalibr_imu_chain.yaml (rpng/open_vins, ov_msckf/src/core/VioManagerOptions.h).
//
//   Kalibr's keys, read by cv::FileStorage: first line %YAML:1.0, lists indented deeper than their key
//   T_imu_cam         p_imu = T p_cam, for every camera (or T_cam_imu; T_cn_cnm1 is not read)
//   lenses            pinhole-radtan and pinhole-equidistant; camera_model is never read
//   timeshift_cam_imu t_imu = t_cam + shift; only cam0's is read
//   imu0              Kalibr's noise keys, and the IMU's own intrinsics Tw, R_IMUtoGYRO, Ta, R_IMUtoACC, Tg
//
// Such files are told from Kalibr's own by OpenCV's first line, which Kalibr refuses, and what OpenVINS stops without: a pose
// to the IMU, the IMU's own intrinsics.
#pragma once

#include <fca/formats/format.h>

namespace fca::openvins {

extern const Format kFormat;

}  // namespace fca::openvins
