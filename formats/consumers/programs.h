// SPDX-License-Identifier: BSD-3-Clause
// Private: the programs behind the table in consumers.cc. None of these functions throws, whatever the bytes are.
#pragma once

#include <array>
#include <string_view>

#include "fca/formats/consumers/consumer.h"

namespace fca::consumers {

/// Which of COLMAP's models some trainers take, as a cameras.txt names them. Where from: splat_loaders.cc.
inline constexpr std::array<std::string_view, 6> kTakenByGsplat = {"SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL",
                                                                   "RADIAL",         "OPENCV",  "OPENCV_FISHEYE"};
inline constexpr std::array<std::string_view, 7> kTakenBy3dgrut = {
    "SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV", "OPENCV_FISHEYE", "FULL_OPENCV"};
/// Of ns-process-data and of instant-ngp's colmap2nerf.py.
inline constexpr std::array<std::string_view, 8> kTakenByNerfstudio = {
    "SIMPLE_PINHOLE", "PINHOLE",        "SIMPLE_RADIAL",         "RADIAL",
    "OPENCV",         "OPENCV_FISHEYE", "SIMPLE_RADIAL_FISHEYE", "RADIAL_FISHEYE"};
inline constexpr std::array<std::string_view, 9> kTakenByLichtfeld = {
    "SIMPLE_PINHOLE", "PINHOLE",        "SIMPLE_RADIAL",         "RADIAL",        "OPENCV",
    "FULL_OPENCV",    "OPENCV_FISHEYE", "SIMPLE_RADIAL_FISHEYE", "RADIAL_FISHEYE"};

[[nodiscard]] ConsumerView load_basalt(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_colmap(std::string_view bytes, const LoadOptions& options);
/// COLMAP's file and transforms.json.
[[nodiscard]] ConsumerView load_3dgrut(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_cuvslam(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_cuvslam_imu(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_fast_livo(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_gsplat(std::string_view bytes, const LoadOptions& options);
/// transforms.json, and the text file of COLMAP's that colmap2nerf.py makes one of.
[[nodiscard]] ConsumerView load_instant_ngp(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_kalibr(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_kalibr_imu(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_kimera(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_kimera_imu(std::string_view bytes, const LoadOptions& options);
/// COLMAP's file and transforms.json.
[[nodiscard]] ConsumerView load_lichtfeld(std::string_view bytes, const LoadOptions& options);
/// transforms.json, and the file of COLMAP's that ns-process-data makes one of.
[[nodiscard]] ConsumerView load_nerfstudio(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_mrcal(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_okvis(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_okvis2(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_okvis2_x(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_openvins(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_openvins_imu(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_openvslam(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_stella(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_orbslam3(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_orbslam2(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_slam_no_opt(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_urbste(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_opencv(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_ocamcalib(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_woodscape(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_woodscape_omnidet(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_vins(std::string_view bytes, const LoadOptions& options);
/// For those that read with cv::FileStorage, whose libraries the command loads when it asks the first of them.
void prepare_storage_programs();
[[nodiscard]] ConsumerView load_svo(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_maplab(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_ros(std::string_view bytes, const LoadOptions& options);
[[nodiscard]] ConsumerView load_dso(std::string_view bytes, const LoadOptions& options);

}  // namespace fca::consumers
