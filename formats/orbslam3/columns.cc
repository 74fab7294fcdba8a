// SPDX-License-Identifier: BSD-3-Clause
#include "columns.h"

#include <fca/code.h>
#include <fca/rig/overlap.h>

#include <algorithm>
#include <numbers>

namespace fca::orbslam3 {

namespace {

/// What counts as lens, in radians from the axis.
double largest_angle(const Target& target) { return target.max_angle_rad.value_or(std::numbers::pi); }

/// The columns of one camera that another sees, too.
std::optional<ColumnRange> columns_of(const Rig& rig, const Target& target, std::size_t from, std::size_t to) {
  const Camera& camera = rig.cameras[from];
  const Camera& other = rig.cameras[to];
  const std::optional<Transform> T_other_camera = rig.resolve(other.name, camera.name);
  if (!T_other_camera) return std::nullopt;
  return columns_shared(camera, other, *T_other_camera, largest_angle(target));
}

/// The base's columns, as far as somebody set them by hand.
std::vector<OverlapColumn> columns_set_by_hand(const Rig& base, const Target& of_base) {
  std::vector<OverlapColumn> columns = overlap_columns(base, of_base);
  std::erase_if(columns, [&of_base](const OverlapColumn& column) {
    const std::optional<double> stated = of_base.tuning.stated(*column.key);
    return !stated || *stated == column.computed;
  });
  return columns;
}

}  // namespace

std::vector<OverlapColumn> overlap_columns(const Rig& rig, const Target& target) {
  const bool pair = target.sensor.two_cameras && rig.cameras.size() > 1 && target.style != Style::kSlamNoOpt;
  if (!pair || !rig.cameras[0].image_size) return {};
  const Layout* layout = find_layout(target.style, model_info(rig.cameras[1].model).id);
  if (layout == nullptr || !is_fisheye(*layout)) return {};
  std::vector<OverlapColumn> result;
  for (std::size_t i = 0; i < tuning_key::kOverlap.size(); ++i) {
    const ColumnRange all = {0, rig.cameras[i].image_size.value_or(*rig.cameras[0].image_size).width - 1};
    const ColumnRange columns = columns_of(rig, target, i, 1 - i).value_or(all);
    result.push_back({tuning_key::kOverlap.at(i).begin, i, columns.first});
    result.push_back({tuning_key::kOverlap.at(i).end, i, columns.last});
  }
  return result;
}

bool shares_no_columns(const Rig& rig, const Target& target) {
  if (!target.sensor.two_cameras || rig.cameras.size() < 2 || !rig.cameras[0].image_size || !rig.cameras[1].image_size)
    return false;
  const Layout* layout = find_layout(target.style, model_info(rig.cameras[1].model).id);
  if (layout == nullptr || !is_fisheye(*layout)) return false;
  const std::optional<Transform> T_1_0 = rig.resolve(rig.cameras[1].name, rig.cameras[0].name);
  return !T_1_0 || !share_columns(rig.cameras[0], rig.cameras[1], *T_1_0, largest_angle(target));
}

std::array<std::optional<std::size_t>, 2> same_images(const Rig& base, const Rig& rig, std::span<const std::string> replaced) {
  std::array<std::optional<std::size_t>, 2> result;
  for (std::size_t i = 0; i < std::min(result.size(), rig.cameras.size()); ++i) {
    const auto before = std::ranges::find(base.cameras, rig.cameras[i].name, &Camera::name);
    if (std::ranges::find(replaced, rig.cameras[i].name) != replaced.end()) continue;
    if (before == base.cameras.end() || before->image_size != rig.cameras[i].image_size) continue;
    const std::size_t index = static_cast<std::size_t>(before - base.cameras.begin());
    if (index < result.size()) result.at(i) = index;
  }
  return result;
}

void report_columns(const Rig& base, const Target& of_base, const Rig& rig, const Target& target,
                    std::span<const std::string> replaced, Diagnostics& diagnostics) {
  const bool same = std::ranges::equal(base.cameras, rig.cameras) && base.poses == rig.poses && !target.max_angle_rad;
  std::vector<Message> kept;
  for (const OverlapColumn& column : overlap_columns(rig, target)) {
    const std::optional<double> stated = target.tuning.stated(*column.key);
    if (same || !stated || *stated == column.computed) continue;
    const std::string key = target.tuning.field(*column.key, target.style).key;
    kept.push_back({Code::kOrbslam3KeptColumn, {key, *stated, column.computed}});
  }
  if (!kept.empty()) diagnostics.add(Code::kOrbslam3ColumnsKept, {enumerated(kept)});
  const std::array<std::optional<std::size_t>, 2> from = same_images(base, rig, replaced);
  std::vector<Message> gone;
  for (const OverlapColumn& column : columns_set_by_hand(base, of_base)) {
    if (std::ranges::find(from, std::optional(column.camera)) != from.end()) continue;
    const fields::Field was = of_base.tuning.field(*column.key, of_base.style);
    gone.push_back({Code::kOrbslam3GoneColumn, {was.key, was.tokens.front()}});
  }
  if (gone.empty() || overlap_columns(rig, target).empty()) return;
  diagnostics.add(Code::kOrbslam3ColumnsComputed, {enumerated(gone)});
}

}  // namespace fca::orbslam3
