// SPDX-License-Identifier: BSD-3-Clause
// Kalibr: camchain.yaml, camchain-imucam.yaml and imu.yaml (ethz-asl/kalibr, aslam_offline_calibration .../ConfigReader.py).
//
//   cam0, cam1, ...   camera_model, intrinsics, distortion_model, distortion_coeffs, resolution [w, h], rostopic
//   T_cn_cnm1         p_cam(n) = T p_cam(n-1), metres
//   T_cam_imu         p_cam = T p_imu
//   timeshift_cam_imu t_imu = t_cam + timeshift, seconds
//   results-cam.txt   standard deviations: report.h
//   imu.yaml          *_noise_density, *_random_walk (continuous time), update_rate [Hz]; bare or under imu0:
//
// Read too: OpenVINS' spelling of the same (%YAML:1.0, T_imu_cam) and a top-level T_cam1_cam0, which Kalibr itself refuses.
#pragma once

#include <fca/formats/format.h>

namespace fca::kalibr {

extern const Format kFormat;

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::kalibr
