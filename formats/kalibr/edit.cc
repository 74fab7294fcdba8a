// SPDX-License-Identifier: BSD-3-Clause
#include "edit.h"

#include "blocks.h"
#include "layout.h"
#include "overlaps.h"
#include "poses.h"

#include "../sibling.h"

#include <fca/code.h>

#include <algorithm>

namespace fca::kalibr {

using text::Node;

namespace {

std::optional<std::size_t> position_of(const Rig& rig, const std::string& name) {
  const auto found = std::ranges::find(rig.cameras, name, &Camera::name);
  if (found == rig.cameras.end()) return std::nullopt;
  return static_cast<std::size_t>(found - rig.cameras.begin());
}

}  // namespace

Editor::Editor(const text::Document& base, const Rig& old, const Rig& rig_as_named, const Rig& rig)
    : base_(base), document_(base), dialect_(dialect_of(base)), old_(old), as_named_(rig_as_named), rig_(rig) {}

bool Editor::other_cameras() const {
  return !std::ranges::equal(old_.cameras, as_named_.cameras, {}, &Camera::name, &Camera::name);
}

bool Editor::possible() const {
  if (!other_cameras()) return true;
  const auto is_block = [](const text::Entry& entry) { return index_in(entry.key.value, "cam") && !entry.key.quoted; };
  return !document_.root().flow && std::ranges::all_of(document_.root().entries, is_block) &&
         std::ranges::any_of(as_named_.cameras, [this](const Camera& c) { return position_of(old_, c.name).has_value(); });
}

std::vector<Editor::Kept> Editor::kept() const {
  std::vector<Kept> result;
  for (std::size_t i = 0; i < old_.cameras.size(); ++i) {
    const text::Entry* entry = text::find_entry(base_.root(), old_.cameras[i].name, dialect_);
    const std::optional<std::size_t> now = position_of(as_named_, old_.cameras[i].name);
    if (entry != nullptr && now) result.push_back({entry, i, *now});
  }
  return result;
}

Rig Editor::said_by(std::span<const Kept> cameras) const {
  Rig said;
  const auto add = [&](const Node& mapping, const PoseKey& pose) {
    if (text::find(mapping, pose.key, dialect_) == nullptr) return;
    if (const std::optional<Transform> T = pose_in(rig_, pose.a, pose.b)) said.poses.push_back({pose.a, pose.b, *T});
  };
  for (const Kept& camera : cameras) {
    for (const PoseKey& pose : pose_keys(rig_.cameras[camera.now].name)) add(camera.entry->value, pose);
  }
  for (const text::Entry& entry : base_.root().entries) {
    if (const std::optional<PoseKey> pose = named_pose_key(entry.key.value)) add(base_.root(), *pose);
  }
  return said;
}

std::string_view Editor::imu_pose_key() const {
  return states("T_imu_cam") && !states("T_cam_imu") ? "T_imu_cam" : "T_cam_imu";
}

bool Editor::states(std::string_view key) const {
  return std::ranges::any_of(old_.cameras, [&](const Camera& camera) {
    const Node* block = text::find(base_.root(), camera.name, dialect_);
    return block != nullptr && text::find(*block, key, dialect_) != nullptr;
  });
}

std::vector<fields::Field> Editor::fields_before(const Node& block, std::size_t index) const {
  std::vector<fields::Field> result;
  for (const PoseKey& pose : pose_keys(old_.cameras[index].name)) {
    const Transform* T = old_.stated(pose.a, pose.b);
    if (T != nullptr && text::find(block, pose.key, dialect_) != nullptr) result.push_back(fields::rows(pose.key, *T));
  }
  const std::vector<fields::Field> lens = lens_fields(old_.cameras[index]);
  result.insert(result.end(), lens.begin(), lens.end());
  return result;
}

std::vector<fields::Field> Editor::fields_after(const Node& block, std::size_t index) const {
  std::vector<fields::Field> result;
  for (const PoseKey& pose : pose_keys(rig_.cameras[index].name)) {
    const bool there = text::find(block, pose.key, dialect_) != nullptr;
    const bool may_come = pose.key == imu_pose_key() || pose.key == "T_cn_cnm1";
    // Cameras that come or change places are given every pose that this chain specifies of its cameras, also redundant ones.
    const bool habit = other_cameras() && states(pose.key);
    const bool comes = may_come && (habit || lacks_pose(said_, rig_, pose.a, pose.b));
    const std::optional<Transform> T = pose_in(rig_, pose.a, pose.b);
    if (T && (there || comes)) result.push_back(fields::rows(pose.key, *T));
  }
  std::ranges::sort(result, {}, &fields::Field::key);
  const std::vector<fields::Field> lens = lens_fields(rig_.cameras[index]);
  result.insert(result.end(), lens.begin(), lens.end());
  return result;
}

void Editor::edit_named_poses() {
  const auto poses_of = [this](const Rig& rig) {
    std::vector<fields::Field> result;
    for (const text::Entry& entry : base_.root().entries) {
      const std::optional<PoseKey> pose = named_pose_key(entry.key.value);
      const std::optional<Transform> T = pose ? pose_in(rig, pose->a, pose->b) : std::nullopt;
      if (T) result.push_back(fields::rows(pose->key, *T));
    }
    return result;
  };
  fields::apply(document_, document_.root(), dialect_, poses_of(old_), poses_of(rig_));
}

text::Document Editor::edited(std::span<const std::optional<fields::Field>> overlaps, std::vector<Loss>& losses) {
  const Node& root = document_.root();
  const std::vector<Kept> cameras = kept();
  const bool same_places =
      cameras.size() == old_.cameras.size() && std::ranges::equal(cameras, cameras, {}, &Kept::before, &Kept::now);
  said_ = said_by(cameras);
  edit_named_poses();
  for (const Camera& camera : old_.cameras) {
    const text::Entry* entry = text::find_entry(root, camera.name, dialect_);
    if (entry != nullptr && !position_of(as_named_, camera.name)) document_.remove_entry(root, *entry);
  }
  for (const Kept& camera : cameras) {
    const std::string& name = rig_.cameras[camera.now].name;
    if (name != camera.entry->key.value) document_.replace(camera.entry->key.span, name);
    fields::apply(document_, camera.entry->value, dialect_, fields_before(camera.entry->value, camera.before),
                  fields_after(camera.entry->value, camera.now));
    if (!same_places) count_overlaps(*camera.entry, losses);
  }
  for (std::size_t i = 0; i < rig_.cameras.size(); ++i) {
    if (position_of(old_, as_named_.cameras[i].name)) continue;
    const Kept& sibling = cameras.back();
    const Node& block = sibling.entry->value;
    std::vector<fields::Field> fields = fields_after(block, i);
    if (overlaps[i]) fields.insert(std::ranges::find(fields, "camera_model", &fields::Field::key), *overlaps[i]);
    document_.insert_after(root, root.entries.back(),
                           fields::like_sibling(base_, root, *sibling.entry, dialect_, rig_.cameras[i].name,
                                                fields_before(block, sibling.before), fields));
  }
  return std::move(document_);
}

void Editor::count_overlaps(const text::Entry& camera, std::vector<Loss>& losses) {
  const text::Entry* overlaps = text::find_entry(camera.value, kOverlaps, dialect_);
  if (overlaps == nullptr) return;
  if (const std::optional<fields::Field> now = overlaps_among(base_, camera.key.value, as_named_)) {
    fields::apply(document_, camera.value, dialect_, {}, std::vector{*now});
    return;
  }
  document_.remove_entry(camera.value, *overlaps);
  losses.push_back(lost(Code::kNotCarried, camera.key.value, std::string(kOverlaps), {Message{Code::kCamchainOverlapsNoList}}));
}

}  // namespace fca::kalibr
