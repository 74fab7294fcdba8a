// SPDX-License-Identifier: BSD-3-Clause
// Lists the facts of a rig that are lost because a format has no key for them, or rounds them.
#include "../losses.h"

#include "keys.h"
#include "schema.h"

#include <fca/code.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fca::schema {

namespace {

/// The first key of the table, at any depth, for which `wanted` returns true; null if there is none.
const Key* find_key(const Mapping& mapping, const std::function<bool(const Key&)>& wanted) {
  for (const Key& key : mapping.keys) {
    if (wanted(key)) return &key;
    const Key* below = key.with.mapping != nullptr ? find_key(*key.with.mapping, wanted) : nullptr;
    if (below != nullptr) return below;
  }
  return nullptr;
}

/// The first key of the table that writes facts of that kind; null if there is none.
const Key* find_key(const Schema& schema, FactKind kind) {
  return find_key(schema.root, [kind](const Key& key) { return key.fact == kind && key.write != nullptr; });
}

/// Lists the losses of a format with a single time offset for all cameras: other cameras' offsets, and the rounding to units.
void list_common_offset(const Schema& schema, const Key& key, const Rig& rig, std::vector<Loss>& losses) {
  const auto first = std::ranges::find_if(rig.cameras, [](const Camera& camera) { return camera.time_offset_s.has_value(); });
  if (first == rig.cameras.end()) return;
  const double common = first->time_offset_s.value();
  constexpr double kSmallestLossS = 1e-12;  // s; a smaller change by rounding is not reported
  const bool is_rounded = key.with.per_second != 1.0;
  if (is_rounded && std::abs(std::round(common * key.with.per_second) / key.with.per_second - common) > kSmallestLossS)
    losses.push_back(lost(schema.codes.offset_rounded, "", "", {common}));
  add_other_time_offsets(rig, common, Message{schema.codes.one_offset}, losses);
}

/// Lists those of the camera's time offset, topic and frame rate for which the format has no key.
void list_stream(const Schema& schema, Camera camera, const Message& why, std::vector<Loss>& losses) {
  if (holds(schema, FactKind::kTimeOffset)) camera.time_offset_s.reset();
  if (holds(schema, FactKind::kTopic)) camera.topic.clear();
  if (holds(schema, FactKind::kFrameRate)) camera.frame_rate_hz.reset();
  add_stream(camera, why, losses);
}

/// Lists the losses of a format that has one IMU or none.
void list_imus(const Schema& schema, const Rig& rig, const Message& why, std::vector<Loss>& losses) {
  const bool one = holds(schema, FactKind::kImu);
  for (std::size_t i = 0; i < rig.imus.size(); ++i) {
    const Imu& imu = rig.imus[i];
    if (!one) {
      losses.push_back(lost(Code::kImuDropped, imu.name, "", {why}));
    } else if (i > 0) {
      losses.push_back(lost(schema.codes.further_imu, imu.name, ""));
    } else if (!imu.topic.empty()) {
      losses.push_back(lost(Code::kTopicDropped, imu.name, "topic", {why, imu.topic}));
    }
  }
}

}  // namespace

bool holds(const Schema& schema, FactKind kind) { return find_key(schema, kind) != nullptr; }

void list_losses(const Schema& schema, const Rig& rig, const Message& why, std::vector<Loss>& losses) {
  if (const Key* offset = find_key(schema, FactKind::kTimeOffset)) list_common_offset(schema, *offset, rig, losses);
  for (const Camera& camera : rig.cameras) list_stream(schema, camera, why, losses);
  list_imus(schema, rig, why, losses);
  if (rig.baseline_m && !holds(schema, FactKind::kBaseline))
    losses.push_back(lost(Code::kBaselineDropped, "", "baseline", {why, *rig.baseline_m}));
}

std::vector<ExtraField> carried(const Schema& schema, const Rig& rig) {
  std::vector<ExtraField> result;
  for (const ExtraField& extra : rig.extra_fields) {
    const auto writes = [&extra](const Key& key) {
      return key.fact == FactKind::kOther && key.write != nullptr && key.name == extra.key && extra.owner == kImu;
    };
    if (find_key(schema.root, writes) != nullptr) result.push_back(extra);
  }
  return result;
}

}  // namespace fca::schema
