// SPDX-License-Identifier: BSD-3-Clause
// Private: the parts of the table of codes, one topic each. A new one is a file, a function here, and a line in codes.cc.
#pragma once

#include <fca/code.h>

#include <span>

namespace fca::diagnostics {

[[nodiscard]] std::span<const CodeInfo> rig_codes();
[[nodiscard]] std::span<const CodeInfo> command_codes();
[[nodiscard]] std::span<const CodeInfo> loss_codes();
[[nodiscard]] std::span<const CodeInfo> dso_codes();
[[nodiscard]] std::span<const CodeInfo> imu_codes();
[[nodiscard]] std::span<const CodeInfo> limit_codes();
[[nodiscard]] std::span<const CodeInfo> conversion_codes();
[[nodiscard]] std::span<const CodeInfo> comparison_codes();
[[nodiscard]] std::span<const CodeInfo> syntax_codes();
[[nodiscard]] std::span<const CodeInfo> field_codes();
[[nodiscard]] std::span<const CodeInfo> file_codes();
[[nodiscard]] std::span<const CodeInfo> kalibr_codes();
[[nodiscard]] std::span<const CodeInfo> openvins_codes();
[[nodiscard]] std::span<const CodeInfo> tumvi_codes();
[[nodiscard]] std::span<const CodeInfo> ocamcalib_codes();
[[nodiscard]] std::span<const CodeInfo> woodscape_codes();
[[nodiscard]] std::span<const CodeInfo> opencv_codes();
[[nodiscard]] std::span<const CodeInfo> basalt_codes();
[[nodiscard]] std::span<const CodeInfo> table_codes();
[[nodiscard]] std::span<const CodeInfo> slam_codes();
[[nodiscard]] std::span<const CodeInfo> device_codes();
[[nodiscard]] std::span<const CodeInfo> sensor_codes();
[[nodiscard]] std::span<const CodeInfo> mrcal_codes();
[[nodiscard]] std::span<const CodeInfo> uncertainty_codes();
[[nodiscard]] std::span<const CodeInfo> colmap_codes();
[[nodiscard]] std::span<const CodeInfo> nerf_codes();
[[nodiscard]] std::span<const CodeInfo> orbslam3_codes();
[[nodiscard]] std::span<const CodeInfo> vins_codes();
[[nodiscard]] std::span<const CodeInfo> ros_codes();
[[nodiscard]] std::span<const CodeInfo> kalibr_program_codes();
[[nodiscard]] std::span<const CodeInfo> openvins_program_codes();
[[nodiscard]] std::span<const CodeInfo> storage_program_codes();
[[nodiscard]] std::span<const CodeInfo> ros_program_codes();
[[nodiscard]] std::span<const CodeInfo> vins_program_codes();
[[nodiscard]] std::span<const CodeInfo> basalt_program_codes();
[[nodiscard]] std::span<const CodeInfo> sensor_program_codes();
[[nodiscard]] std::span<const CodeInfo> mrcal_program_codes();
[[nodiscard]] std::span<const CodeInfo> colmap_program_codes();
[[nodiscard]] std::span<const CodeInfo> nerf_program_codes();
[[nodiscard]] std::span<const CodeInfo> opencv_program_codes();
[[nodiscard]] std::span<const CodeInfo> ocamcalib_program_codes();
[[nodiscard]] std::span<const CodeInfo> woodscape_program_codes();
[[nodiscard]] std::span<const CodeInfo> orbslam_program_codes();
[[nodiscard]] std::span<const CodeInfo> proof_codes();
[[nodiscard]] std::span<const CodeInfo> file_check_codes();
[[nodiscard]] std::span<const CodeInfo> lens_check_codes();
[[nodiscard]] std::span<const CodeInfo> pose_check_codes();
[[nodiscard]] std::span<const CodeInfo> general_codes();
[[nodiscard]] std::span<const CodeInfo> reading_codes();
[[nodiscard]] std::span<const CodeInfo> convert_codes();
[[nodiscard]] std::span<const CodeInfo> request_codes();
[[nodiscard]] std::span<const CodeInfo> verdict_codes();

}  // namespace fca::diagnostics
