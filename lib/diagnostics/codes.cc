// SPDX-License-Identifier: BSD-3-Clause
#include "rows.h"
#include "topics.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fca {

namespace {

/// The rows of all topics.
auto topics() {
  return std::array{
      diagnostics::rig_codes(),
      diagnostics::command_codes(),
      diagnostics::loss_codes(),
      diagnostics::dso_codes(),
      diagnostics::imu_codes(),
      diagnostics::limit_codes(),
      diagnostics::conversion_codes(),
      diagnostics::comparison_codes(),
      diagnostics::syntax_codes(),
      diagnostics::field_codes(),
      diagnostics::file_codes(),
      diagnostics::kalibr_codes(),
      diagnostics::openvins_codes(),
      diagnostics::tumvi_codes(),
      diagnostics::ocamcalib_codes(),
      diagnostics::woodscape_codes(),
      diagnostics::opencv_codes(),
      diagnostics::basalt_codes(),
      diagnostics::table_codes(),
      diagnostics::slam_codes(),
      diagnostics::device_codes(),
      diagnostics::sensor_codes(),
      diagnostics::mrcal_codes(),
      diagnostics::uncertainty_codes(),
      diagnostics::colmap_codes(),
      diagnostics::nerf_codes(),
      diagnostics::orbslam3_codes(),
      diagnostics::vins_codes(),
      diagnostics::ros_codes(),
      diagnostics::kalibr_program_codes(),
      diagnostics::openvins_program_codes(),
      diagnostics::storage_program_codes(),
      diagnostics::ros_program_codes(),
      diagnostics::vins_program_codes(),
      diagnostics::basalt_program_codes(),
      diagnostics::sensor_program_codes(),
      diagnostics::mrcal_program_codes(),
      diagnostics::colmap_program_codes(),
      diagnostics::nerf_program_codes(),
      diagnostics::opencv_program_codes(),
      diagnostics::ocamcalib_program_codes(),
      diagnostics::woodscape_program_codes(),
      diagnostics::orbslam_program_codes(),
      diagnostics::proof_codes(),
      diagnostics::file_check_codes(),
      diagnostics::lens_check_codes(),
      diagnostics::pose_check_codes(),
      diagnostics::general_codes(),
      diagnostics::reading_codes(),
      diagnostics::convert_codes(),
      diagnostics::request_codes(),
      diagnostics::verdict_codes(),
  };
}

std::size_t place_of(Code code) { return static_cast<std::size_t>(code) - 1; }

/// The same, each at the place of its code: to sort them takes as long as reading a file. What has the code of another comes
/// after all, where a test finds it.
std::vector<CodeInfo> joined_topics() {
  std::vector<CodeInfo> rows(place_of(Code::kCount), CodeInfo{});
  std::vector<CodeInfo> further;
  for (const std::span<const CodeInfo> topic : topics()) {
    for (const CodeInfo& row : topic) {
      CodeInfo& place = rows[place_of(row.code)];
      (place.code == Code::kNone ? place : further.emplace_back()) = row;
    }
  }
  rows.insert(rows.end(), further.begin(), further.end());
  return rows;
}

}  // namespace

std::span<const CodeInfo> all_codes() {
  static const std::vector<CodeInfo> rows = joined_topics();
  return rows;
}

const CodeInfo* find_code(std::string_view id) {
  const auto row = std::ranges::find(all_codes(), id, &CodeInfo::id);
  return id == diagnostics::kClauseId || row == all_codes().end() ? nullptr : &*row;
}

const CodeInfo& info(Code code) {
  static constexpr CodeInfo kNothing = {.code = Code::kNone, .id = "", .text = ""};
  return code > Code::kNone && code < Code::kCount ? all_codes()[place_of(code)] : kNothing;
}

}  // namespace fca
