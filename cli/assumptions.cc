// SPDX-License-Identifier: BSD-3-Clause
#include "assumptions.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace fca::cli {

namespace {

/// The poses that files of formats without a unit state; also those of --with.
std::vector<PoseEdge> poses_without_unit(const Calibration& calibration) {
  std::vector<PoseEdge> poses;
  for (const text::Document& document : calibration.documents) {
    Diagnostics said_before;
    const bool main_file = &document == &calibration.documents.front();
    const std::optional<DetectedFormat> detected = main_file ? std::nullopt : detect_format(document, said_before);
    const Format& format = detected ? *detected->format : *calibration.format;
    if (!format.any_length_unit) continue;
    const std::optional<Rig> rig = format.read(std::span(&document, 1), {}, said_before);
    if (rig) poses.insert(poses.end(), rig->poses.begin(), rig->poses.end());
  }
  return poses;
}

}  // namespace

bool has_assumed_unit(const PoseEdge& edge, const Calibration& calibration) {
  // By its numbers: files that are joined name their cameras anew.
  return std::ranges::any_of(poses_without_unit(calibration),
                             [&edge](const PoseEdge& other) { return other.T_a_b == edge.T_a_b; });
}

void list_assumed_units(const Calibration& calibration, const Format& to, Written& written) {
  if (to.any_length_unit || !to.extrinsics) return;
  const Rig& rig = calibration.rig;
  const bool posed = std::ranges::any_of(rig.cameras, [&rig](const Camera& camera) {
    return camera.name != rig.cameras.front().name && rig.resolve(camera.name, rig.cameras.front().name);
  });
  if (posed && !poses_without_unit(calibration).empty())
    written.defaults.push_back({"translation unit", "taken as metres", true});
}

}  // namespace fca::cli
