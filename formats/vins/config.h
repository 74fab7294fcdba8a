// SPDX-License-Identifier: BSD-3-Clause
// VINS-Fusion's configuration (vins_estimator/src/estimator/parameters.cpp), read by cv::FileStorage, whose cameras stand in
// files of their own next to it:
//
//   num_of_cam                   1 or 2
//   cam0_calib, cam1_calib       camera files, relative to the configuration's folder
//   image0_topic, image1_topic
//   image_width, image_height    of both
//   body_T_cam0, body_T_cam1     4 x 4, dt d: p_imu = T p_cam. With estimate_extrinsic 2 that of cam0 is not read
//   acc_n, gyr_n, acc_w, gyr_w   what one IMU sample's noise is (integration_base.h multiplies them with the time between two
//                                samples, not with its root): densities times sqrt(rate), and no rate stands there
//   td                           s: t_imu = t_cam + td
//
// Everything else tunes the program. What is missing it takes for 0.
#pragma once

#include "layout.h"

#include <fca/formats/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::vins {

[[nodiscard]] bool is_config(const text::Document& document);

/// The nodes that name camera files, of as many cameras as it uses.
[[nodiscard]] std::vector<const text::Node*> camera_files_of(const text::Document& config);

/// What the configuration and its camera files, if they are there, say together.
void read_config(const text::Document& config, std::span<const text::Document> camera_files, const ReadOptions& options,
                 Rig& rig, Diagnostics& diagnostics);

/// The configuration, edited, and the camera files that it names.
[[nodiscard]] std::optional<Written> write_config(const text::Document& base, const Rig& rig, Diagnostics& diagnostics);

/// What VINS-Fusion takes for one sample's noise: the density times sqrt(rate).
struct Noise {
  std::string_view key;
  std::optional<double> Imu::*density;
};
inline constexpr std::array kNoises = {
    Noise{"acc_n", &Imu::accelerometer_noise_density}, Noise{"gyr_n", &Imu::gyroscope_noise_density},
    Noise{"acc_w", &Imu::accelerometer_random_walk}, Noise{"gyr_w", &Imu::gyroscope_random_walk}};

/// What VINS-Fusion uses at once.
inline constexpr std::size_t kMostCameras = 2;

}  // namespace fca::vins
