// SPDX-License-Identifier: BSD-3-Clause
// Basalt's calibration JSON (VladyslavUsenko/basalt-headers, serialization/headers_serialization.h and
// calibration/calibration.hpp).
//
//   value0
//     intrinsics          per camera: camera_type and, below a second "intrinsics", its parameters by name
//     T_imu_cam           per camera: px py pz [m], qx qy qz qw: p_imu = T p_cam
//     resolution          per camera: [w, h]
//     cam_time_offset_ns  one for all cameras: t_imu = t_cam + offset
//     imu_update_rate     Hz
//     gyro_noise_std, accel_noise_std, gyro_bias_std, accel_bias_std   continuous-time densities, one number per axis
//     calib_accel_bias    9: bias and six elements of scale; calib_gyro_bias 12: bias and nine
//     vignette            a spline per camera, or none
//
// Basalt stops where one of these keys is missing; their order is free and further keys are ignored (T_mocap_world, ...).
// Versions before 2020 had one number for each noise. Those since 2022 read pinhole-radtan8.
#pragma once

#include <fca/formats/format.h>

namespace fca::basalt {

extern const Format kFormat;

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::basalt
