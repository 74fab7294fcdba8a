// SPDX-License-Identifier: BSD-3-Clause
#include "base.h"

#include "columns.h"
#include "orbslam3.h"

#include "../losses.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace fca::orbslam3 {

namespace {

/// Keys that one sensor mode or another asks for, in both styles.
bool is_of_a_mode(std::string_view key) {
  constexpr std::array<std::string_view, 4> kGroups = {"Camera2.", "Stereo.", "RGBD.", "IMU."};
  if (std::ranges::any_of(kGroups, [key](std::string_view group) { return key.starts_with(group); })) return true;
  const PoseKeys old = pose_keys(Style::kOld);
  if (key == old.T_c1_c2 || key == old.T_imu_c1 || key == "Camera.bf") return true;
  const TuningKey* tuning = find_tuning_key(key);
  if (tuning == nullptr || tuning->key == tuning_key::kColourOrder.key) return false;
  return std::ranges::find(program_tuning(), tuning->key, &TuningKey::key) == program_tuning().end();  // those are of all
}

/// The type that the base specifies, where the camera put in is of another: "Rectified" of a camera without distortion is
/// PinHole's other name for as long as it has none.
void take_type_as_stated(const Base& base, std::string_view model, std::vector<fields::Field>& before) {
  const text::Node* stated = find_key(base.document, "Camera.type");
  const auto type = std::ranges::find(before, "Camera.type", &fields::Field::key);
  if (stated == nullptr || !stated->is_scalar() || type == before.end()) return;
  const bool fits = std::ranges::any_of(layouts(), [&](const Layout& layout) {
    return layout.style == base.target.style && layout.type == stated->value && layout.model == model;
  });
  if (!fits) *type = fields::quoted("Camera.type", stated->value);
}

/// What the base lacks, or says as its program does not know it, comes with the new cameras: columns, which follow from the
/// pair, and the name of the model (slam_no_opt's own files also say KannalaBrandt8, which it takes for none).
void demand_what_is_missing(const Base& base, std::vector<fields::Field>& before) {
  for (const OverlapColumn& column : overlap_columns(base.rig, base.target)) {
    const std::string key = base.target.tuning.field(*column.key, base.target.style).key;
    if (find_key(base.document, key) == nullptr)
      std::erase_if(before, [&key](const fields::Field& field) { return field.key == key; });
  }
  const text::Node* stated = find_key(base.document, "Camera.type");
  const auto type = std::ranges::find(before, "Camera.type", &fields::Field::key);
  if (base.target.style == Style::kSlamNoOpt && stated != nullptr && stated->is_scalar() && type != before.end())
    *type = fields::quoted("Camera.type", stated->value);
}

}  // namespace

Sensor sensor_of(const text::Document& document, const Rig& rig, Style style) {
  const bool depth = find_key(document, "RGBD.DepthMapFactor") != nullptr || find_key(document, "DepthMapFactor") != nullptr;
  const bool posed = rig.cameras.size() > 1 && rig.resolve(rig.cameras[0].name, rig.cameras[1].name);
  const text::Node* type = find_key(document, "Camera.type");
  // Settings of an RGB-D sensor specify a baseline, too.
  const bool said = style_of(document) != Style::kV1 || (type != nullptr && type->value == "Rectified");
  // Before V1.0, Camera.bf is read next to a PinHole's distortion, too, and follows its focal length.
  const bool before_v1 = style == Style::kOld || style == Style::kOrbSlam2;
  const bool states_bf = before_v1 && rig.cameras.size() == 1 && rig.baseline_m &&
                         model_info(rig.cameras.front().model).id == "radtan" && find_key(document, "Camera.bf") != nullptr;
  const bool rectified = !depth && ((is_rectified_pair(rig) && said) || states_bf);
  const bool two = posed || rectified;
  const bool inertial = missing_for(rig, *find_sensor("mono-inertial"), style).empty() &&
                        !(depth && !two && crashes_with_depth_and_imu(rig, style));
  const auto* const found = std::ranges::find_if(kSensors, [&](const Sensor& candidate) {
    return candidate.two_cameras == two && candidate.depth == (depth && !two) && candidate.inertial == inertial;
  });
  return found == kSensors.end() ? *find_sensor("mono") : *found;
}

std::optional<Base> read_base(const text::Document* document) {
  if (document == nullptr) return std::nullopt;
  Diagnostics ignored;
  std::optional<Rig> rig = read(std::span(document, 1), {}, ignored);
  if (!rig) return std::nullopt;
  const Style style = style_of(*document);
  const std::optional<double> rate = rig->cameras.front().frame_rate_hz;
  Target target{style,
                sensor_of(*document, *rig, style),
                rate.value_or(kUpstreamFrameRate),
                rate.has_value(),
                Tuning(*document),
                {},
                find_key(*document, kDelayKey) != nullptr,
                imu_pose_key(*document)};
  return Base{*document, *std::move(rig), std::move(target)};
}

std::vector<fields::Field> fields_of(const Base& base, const Rig& rig, std::span<const fields::Field> after,
                                     const WriteOptions& options) {
  std::vector<fields::Field> before = settings_fields(base.rig, base.target);
  take_type_as_stated(base, model_info(rig.cameras.front().model).id, before);
  const auto same_facts = [](Camera stated, const Camera& meant) {
    stated.lens_circle = meant.lens_circle;  // which no file specifies
    return stated == meant;
  };
  const bool same = std::ranges::equal(base.rig.cameras, rig.cameras, same_facts) && base.rig.poses == rig.poses;
  if (options.keeps_layout && !same) demand_what_is_missing(base, before);
  // A time offset that the rig does not know is none that it contradicts.
  if (!rig.cameras.front().time_offset_s)
    std::erase_if(before, [](const fields::Field& field) { return field.key == kDelayKey; });
  const auto is_among = [](std::span<const fields::Field> fields, std::string_view key) {
    return std::ranges::find(fields, key, &fields::Field::key) != fields.end();
  };
  if (!options.sensor.empty()) {
    for (const text::Entry& entry : base.document.root().entries) {
      const std::string& key = entry.key.value;
      if (is_of_a_mode(key) && !is_among(before, key) && !is_among(after, key)) before.push_back(fields::scalar(key, ""));
    }
    return before;
  }
  // Thresholds of depth are as true as before.
  std::erase_if(before, [&](const fields::Field& field) {
    const TuningKey* key = find_tuning_key(field.key);
    const bool of_depth =
        key != nullptr && (key->key == tuning_key::kThDepth.key || key->key == tuning_key::kDepthMapFactor.key);
    return of_depth && !is_among(after, field.key);
  });
  if (base.rig.baseline_m != rig.baseline_m) return before;
  std::erase_if(before, [&](const fields::Field& field) { return field.key == "Stereo.b" && !is_among(after, field.key); });
  return before;
}

void list_left_keys(const Base& base, std::span<const fields::Field> after, const Target& target, std::vector<Loss>& losses) {
  std::vector<ExtraField> left;
  for (const ExtraField& extra : base.rig.extra_fields) {
    if (is_of_a_mode(extra.key) && std::ranges::find(after, extra.key, &fields::Field::key) == after.end())
      left.push_back(extra);
  }
  add_not_carried(left, Message{Code::kOrbslam3NoSuchKey, {target.sensor.id}}, losses);
}

void warn_of_other_baseline(const Base& base, std::span<const fields::Field> after, Diagnostics& diagnostics) {
  constexpr double kAnother = 0.01;
  const text::Node* node = find_key(base.document, "Camera.bf");
  if (node == nullptr) return;
  const double stated = text::parse_real(node->value).value_or(0.0);
  const std::vector<fields::Field> before = settings_fields(base.rig, base.target);
  const auto implied = std::ranges::find(before, "Camera.bf", &fields::Field::key);
  const auto now = std::ranges::find(after, "Camera.bf", &fields::Field::key);
  if (implied == before.end() || now == after.end() || *now == *implied) return;
  const double from_poses = text::parse_real(implied->tokens.front()).value_or(stated);
  if (std::abs(stated - from_poses) <= kAnother * std::abs(from_poses)) return;
  diagnostics.add(Code::kOrbslam3OtherBaseline, {node->value, from_poses}, base.document.range(*node));
}

void warn_of_poorer_mode(const Base& base, const Rig& rig, const Target& target, Diagnostics& diagnostics) {
  const Sensor& before = base.target.sensor;
  const Sensor& now = target.sensor;
  const bool poorer = (before.two_cameras && !now.two_cameras) || (before.depth && !now.depth && !now.two_cameras) ||
                      (before.inertial && !now.inertial);
  if (!poorer) return;
  const std::vector<Message> missing = missing_for(rig, before, target.style);
  if (!missing.empty()) diagnostics.add(Code::kOrbslam3PoorerMode, {before.id, now.id, enumerated(missing)});
}

std::vector<fields::Field> new_fields(const std::vector<fields::Field>& fields, const Base& base) {
  std::vector<fields::Field> result;
  const std::vector<fields::Field> before = settings_fields(base.rig, base.target);
  std::ranges::copy_if(fields, std::back_inserter(result), [&](const fields::Field& field) {
    const bool was = std::ranges::find(before, field.key, &fields::Field::key) != before.end();
    return !was && find_key(base.document, field.key) == nullptr;
  });
  return result;
}

}  // namespace fca::orbslam3
