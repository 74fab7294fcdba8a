// SPDX-License-Identifier: BSD-3-Clause
#include "basalt.h"
#include "layout.h"

#include "../fields.h"
#include "../losses.h"
#include "../one_camera_files.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <iterator>

namespace fca::basalt {

using fields::Field;
using text::Node;

namespace {

std::vector<Field> parameter_fields(const Camera& camera) {
  std::vector<Field> result;
  for (const Parameter& parameter : model_info(camera.model).parameters)
    result.push_back(fields::real(std::string(parameter.name), fca::parameter(camera.model, ParameterId(parameter)).value()));
  return result;
}

bool is_radtan8(const Camera& camera) { return type_of(model_info(camera.model).id) == "pinhole-radtan8"; }

Field type_field(const Camera& camera) { return fields::quoted("camera_type", type_of(model_info(camera.model).id)); }

std::vector<Field> translation_fields(const Transform& T) {
  const std::array<double, 3> t = translation_of(T);
  return {fields::real("px", t[0]), fields::real("py", t[1]), fields::real("pz", t[2])};
}

std::vector<Field> rotation_fields(const Quaternion& q) {
  return {fields::real("qx", q[0]), fields::real("qy", q[1]), fields::real("qz", q[2]), fields::real("qw", q[3])};
}

Quaternion nearest_quaternion(const Transform& T) { return quaternion_of(nearest_rotation(T).value_or(T)); }

/// The one time offset that Basalt has for all cameras, in its nanoseconds: the first that is stated.
std::optional<double> common_time_offset(const Rig& rig) {
  for (const Camera& camera : rig.cameras) {
    if (camera.time_offset_s) return camera.time_offset_s;
  }
  return std::nullopt;
}

Field time_field(const std::optional<double>& offset_s) {
  return fields::scalar("cam_time_offset_ns", std::to_string(nanoseconds(offset_s.value_or(0.0))));
}

void list_time_losses(const Rig& rig, std::vector<Loss>& losses) {
  const std::optional<double> common = common_time_offset(rig);
  if (!common) return;
  constexpr double kExact = 1e-12;
  if (std::abs(seconds(static_cast<double>(nanoseconds(*common))) - *common) > kExact)
    losses.push_back(lost(Code::kBasaltOffsetRounded, "", "", {*common}));
  add_other_time_offsets(rig, *common, Message{Code::kBasaltOneOffset}, losses);
}

std::vector<Field> imu_fields(const Imu& imu) {
  std::vector<Field> result;
  if (imu.rate_hz) result.push_back(fields::real(std::string(kRate), *imu.rate_hz));
  for (const Noise& noise : kNoises) {
    if (const std::optional<double>& value = imu.*noise.member)
      result.push_back(fields::list(std::string(noise.key), std::array{*value, *value, *value}));
  }
  return result;
}

/// The poses T_imu_cam of a rig: relative to its IMU, else to its first camera.
class ImuPoses {
 public:
  explicit ImuPoses(const Rig& rig) : rig_(rig), frame_(rig.imus.empty() ? std::string(kImu) : rig.imus.front().name) {
    known_ = std::ranges::any_of(rig.cameras, [this](const Camera& camera) { return pose(camera).has_value(); });
    if (!known_) frame_ = rig.cameras.front().name;
  }
  /// Is any camera's pose relative to the IMU known?
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] const std::string& frame() const { return frame_; }
  [[nodiscard]] std::optional<Transform> pose(const Camera& camera) const {
    const Transform* stated = rig_.stated(frame_, camera.name);
    return stated != nullptr ? *stated : rig_.resolve(frame_, camera.name);
  }

 private:
  const Rig& rig_;
  std::string frame_;
  bool known_ = false;
};

/// A quaternion says a rotation only; a matrix printed with few digits, or a product of such, is not quite one.
void list_restated(const ImuPoses& poses, const Camera& camera, const Transform& T, Written& written) {
  const Transform said = pose_of(nearest_quaternion(T), translation_of(T));
  constexpr double kRounding = 1e-9;
  const double off = largest_difference(said, T).distance;
  if (!poses.known() || off <= kRounding) return;
  written.restated.push_back({poses.frame(), camera.name, said});
  written.losses.push_back(lost(Code::kBasaltPoseRecomputed, camera.name, "T_imu_cam", {poses.frame(), off}));
}

std::string with_indentation(const std::vector<Field>& fields, std::size_t indentation) {
  std::string text;
  for (const Field& field : fields)
    text += (text.empty() ? "" : ",\n") + fields::spell(field, indentation, text::Syntax::kJson);
  return text;
}

std::string numbers(std::span<const double> values) {
  return fields::spell(fields::list("", values), 0, text::Syntax::kJson).substr(std::string_view("\"\": ").size());
}

/// A list that a Basalt file had, from what was read of it; zeros where it said nothing.
std::vector<double> bias_of(const Rig& rig, const Bias& bias) {
  std::vector<double> values(bias.count, 0.0);
  const ExtraField* extra = rig.find_extra_field(kImu, bias.key);
  if (extra == nullptr) return values;
  const std::vector<double> read = text::reals_in(extra->value).value_or(std::vector<double>());
  return read.size() == bias.count ? read : values;
}

bool is_carried(const ExtraField& extra) {
  return std::ranges::any_of(kBiases, [&extra](const Bias& bias) { return extra.owner == kImu && extra.key == bias.key; });
}

/// The IMU with what Basalt begins from in place of what is not known.
Imu completed(const Rig& rig, std::vector<DefaultedValue>& defaults) {
  Imu imu = rig.imus.empty() ? Imu{} : rig.imus.front();
  const auto complete = [&](std::optional<double>& value, std::string_view key, double initial) {
    if (value) return;
    value = initial;
    defaults.push_back({std::string(key), Message{Code::kBasaltInitialValue, {initial}}, true, true});
  };
  complete(imu.rate_hz, kRate, kInitialRate);
  for (const Noise& noise : kNoises) complete(imu.*noise.member, noise.key, noise.initial);
  return imu;
}

/// A fresh calibration.
std::string compose(const Rig& rig, const ImuPoses& poses, Written& written) {
  std::string text = "{\n  \"value0\": {\n    \"T_imu_cam\": [";
  std::string separator = "\n";
  for (const Camera& camera : rig.cameras) {
    const std::optional<Transform> T = poses.pose(camera);
    if (!poses.known() || !T) {
      const bool in_frame = T && poses.frame() != camera.name;
      const Message value = in_frame ? Message{Code::kBasaltPoseInFrame, {poses.frame()}} : Message{Code::kBasaltIdentity};
      written.defaults.push_back({camera.name + " T_imu_cam", value, true, true});
    }
    std::vector<Field> fields = translation_fields(T.value_or(Transform{}));
    std::ranges::move(rotation_fields(nearest_quaternion(T.value_or(Transform{}))), std::back_inserter(fields));
    if (T) list_restated(poses, camera, *T, written);
    text += separator + "      {\n" + with_indentation(fields, 8) + "\n      }";
    separator = ",\n";
  }
  text += "\n    ],\n    \"intrinsics\": [";
  separator = "\n";
  for (const Camera& camera : rig.cameras) {
    std::vector<Field> parameters = parameter_fields(camera);
    if (is_radtan8(camera)) parameters.push_back(fields::real(std::string(kMaxRadius), kNoMaxRadius));
    text += separator + "      {\n" + fields::spell(type_field(camera), 8, text::Syntax::kJson) +
            ",\n        \"intrinsics\": {\n" + with_indentation(parameters, 10) + "\n        }\n      }";
    separator = ",\n";
  }
  text += "\n    ],\n    \"resolution\": [";
  separator = "";
  for (const Camera& camera : rig.cameras) {
    text += separator + "[" + std::to_string(camera.image_size->width) + ", " + std::to_string(camera.image_size->height) + "]";
    separator = ", ";
  }
  text += "],\n";
  for (const Bias& bias : kBiases) text += "    \"" + std::string(bias.key) + "\": " + numbers(bias_of(rig, bias)) + ",\n";
  text += with_indentation(imu_fields(completed(rig, written.defaults)), 4) + ",\n" +
          fields::spell(time_field(common_time_offset(rig)), 4, text::Syntax::kJson);
  return text + ",\n    \"vignette\": []\n  }\n}\n";
}

/// A base that says something else of the same cameras.
class Editor {
 public:
  Editor(const text::Document& base, const Rig& old, const Rig& rig)
      : document_(base), value_(*text::find(base.root(), "value0", kDialect)), old_(old), rig_(rig) {}

  /// Are the cameras the base's, one for one?
  [[nodiscard]] static bool possible(const Rig& old, const Rig& rig) {
    return std::ranges::equal(old.cameras, rig.cameras, {}, &Camera::name, &Camera::name);
  }

  text::Document run(Written& written) {
    for (std::size_t i = 0; i < rig_.cameras.size(); ++i) {
      edit_lens(i, written.losses);
      edit_size(i);
    }
    edit_poses(written);
    edit_imu();
    const Field before = time_field(common_time_offset(old_));
    const Field after = time_field(common_time_offset(rig_));
    if (before != after) fields::apply(document_, value_, kDialect, std::span(&before, 1), std::span(&after, 1));
    return std::move(document_);
  }

 private:
  /// The item of the camera of that index in the list under a key; null if there is none.
  const Node* item(std::string_view key, std::size_t index) const {
    const Node* list = text::find(value_, key, kDialect);
    return list != nullptr && index < list->items.size() ? &list->items[index] : nullptr;
  }

  void edit_lens(std::size_t index, std::vector<Loss>& losses) {
    const Camera& before = old_.cameras[index];
    const Camera& after = rig_.cameras[index];
    if (before.model == after.model) return;
    const Node& camera = *item("intrinsics", index);
    fields::apply(document_, camera, kDialect, std::vector{type_field(before)}, std::vector{type_field(after)});
    std::vector<Field> from = parameter_fields(before);
    std::vector<Field> to = parameter_fields(after);
    const Field no_limit = fields::real(std::string(kMaxRadius), kNoMaxRadius);
    if (is_radtan8(before)) from.push_back(no_limit);
    if (is_radtan8(after)) to.push_back(no_limit);
    if (old_.find_extra_field(after.name, kMaxRadius) != nullptr) {
      const std::string limit(kMaxRadius);
      losses.push_back(is_radtan8(after)
                           ? lost(Code::kBasaltStaleRadius, after.name, limit)
                           : lost(Code::kNotCarried, after.name, limit, {Message{Code::kBasaltNoRadiusLimit, {after.name}}}));
    }
    fields::apply(document_, *text::find(camera, "intrinsics", kDialect), kDialect, from, to);
  }

  void edit_size(std::size_t index) {
    const std::optional<ImageSize>& size = rig_.cameras[index].image_size;
    const Node* node = item("resolution", index);
    if (!size || old_.cameras[index].image_size == size || node == nullptr) return;
    fields::set_scalar(document_, node->items[0], std::to_string(size->width));
    fields::set_scalar(document_, node->items[1], std::to_string(size->height));
  }

  void edit_poses(Written& written) {
    const ImuPoses poses(rig_);
    if (!poses.known()) return;
    for (std::size_t i = 0; i < rig_.cameras.size(); ++i) {
      const Node* node = item("T_imu_cam", i);
      const std::optional<Transform> now = poses.pose(rig_.cameras[i]);
      const Transform* stated = old_.stated(kImu, old_.cameras[i].name);
      if (node == nullptr || stated == nullptr || !now || *stated == *now) continue;
      fields::apply(document_, *node, kDialect, translation_fields(*stated), translation_fields(*now));
      constexpr double kSameRotation = 1e-12;
      if (largest_difference(*stated, *now).distance <= kSameRotation) continue;
      const Quaternion before = quaternion_in(*node);
      fields::apply(document_, *node, kDialect, rotation_fields(before),
                    rotation_fields(signed_as(nearest_quaternion(*now), before)));
      list_restated(poses, rig_.cameras[i], *now, written);
    }
  }

  static Quaternion quaternion_in(const Node& pose) {
    Quaternion q{};
    constexpr std::array<std::string_view, 4> kKeys = {"qx", "qy", "qz", "qw"};
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Node* number = text::find(pose, kKeys.at(i), kDialect);
      if (number != nullptr) q.at(i) = text::parse_real(number->value).value_or(0.0);
    }
    return q;
  }

  /// What the rig does not state stays.
  void edit_imu() {
    if (rig_.imus.empty()) return;
    const Imu before = old_.imus.empty() ? Imu{} : old_.imus.front();
    Imu after = rig_.imus.front();
    if (!after.rate_hz) after.rate_hz = before.rate_hz;
    for (const Noise& noise : kNoises) {
      if (!(after.*noise.member)) after.*noise.member = before.*noise.member;
    }
    fields::apply(document_, value_, kDialect, imu_fields(before), imu_fields(after));
  }

  text::Document document_;
  const Node& value_;
  const Rig& old_;
  const Rig& rig_;
};

/// False with an error if a pose is a mirror image: no quaternion says one.
bool are_rotations(const Rig& rig, Diagnostics& diagnostics) {
  const ImuPoses poses(rig);
  bool good = true;
  for (const Camera& camera : rig.cameras) {
    const std::optional<Transform> T = poses.pose(camera);
    if (!T || rotation_determinant(*T) > 0.0) continue;
    diagnostics.add(Code::kBasaltMirror, {camera.name, poses.frame()});
    good = false;
  }
  return good;
}

/// What a Basalt calibration has no place for.
void list_losses(const Rig& rig, std::vector<Loss>& losses) {
  const Message no_place = {Code::kBasaltNoPlace};
  for (Camera camera : rig.cameras) {
    camera.time_offset_s.reset();
    add_stream(camera, no_place, losses);
  }
  for (std::size_t i = 0; i < rig.imus.size(); ++i) {
    const Imu& imu = rig.imus[i];
    if (i > 0) losses.push_back(lost(Code::kBasaltImuDropped, imu.name, ""));
    if (i == 0 && !imu.topic.empty()) losses.push_back(lost(Code::kTopicDropped, imu.name, "topic", {no_place, imu.topic}));
  }
  if (rig.baseline_m) losses.push_back(lost(Code::kBaselineDropped, "", "baseline", {no_place, *rig.baseline_m}));
}

}  // namespace

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> old = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const bool edits = old && !options.anew && Editor::possible(*old, rig);
  if (edits ? !can_store(kFormat, rig, &*old, diagnostics)
            : !writable_alone(kFormat, rig, Message{Code::kBasaltDemandsSize}, diagnostics))
    return std::nullopt;
  if (!are_rotations(rig, diagnostics)) return std::nullopt;

  Written written;
  std::optional<text::Document> document;
  std::vector<ExtraField> said;
  if (edits) {
    document = Editor(*base, *old, rig).run(written);
    said = old->extra_fields;
  } else {
    document = text::parse_document({"calibration.json", compose(rig, ImuPoses(rig), written)}, diagnostics);
    std::ranges::copy_if(rig.extra_fields, std::back_inserter(said), is_carried);
  }
  if (!document) return std::nullopt;
  written.files.push_back({*std::move(document), {}, {"basalt"}});
  for (const Camera& camera : rig.cameras) written.files.front().cameras.push_back(camera.name);
  add_beyond_base(rig.extra_fields, said, Message{Code::kBasaltNoPlace}, written.losses);
  if (old && !edits) {
    add_not_carried(extras_beyond(extras_beyond(old->extra_fields, rig.extra_fields), said), Message{Code::kComposedAnew},
                    written.losses);
  }
  list_time_losses(rig, written.losses);
  list_losses(rig, written.losses);
  written.headline = {Code::kBasaltWrote};
  return written;
}

}  // namespace fca::basalt
