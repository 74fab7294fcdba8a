// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"

#include "layout.h"
#include "poses.h"

#include "../schema/keys.h"

#include <fca/code.h>

#include <algorithm>
#include <array>

namespace fca::kalibr {

using schema::FactKind;
using schema::Key;
using schema::Reading;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

const Layout& layout_of(const Subject& subject) { return *layout_for(subject.the_camera().model); }

std::vector<Statement> write_name(const Key& key, std::string_view name) {
  return schema::states(fields::scalar(key.text(), std::string(name)), {FactKind::kModel});
}

std::vector<Statement> write_slots(const Subject& subject, const Key& key, std::span<const Slot> slots) {
  const CameraModel& model = subject.the_camera().model;
  std::vector<double> values;
  Statement statement;
  for (const Slot& slot : slots) {
    values.push_back(slot.parameter ? parameter(model, *slot.parameter).value() : slot.constant);
    statement.facts.push_back({.kind = FactKind::kParameter, .parameter = slot.parameter ? slot.parameter->name() : ""});
  }
  statement.field = fields::list(key.text(), values);
  return {statement};
}

bool read_resolution(Reading& reading, const Key& key, const Node& node) {
  if (!node.is_sequence() || node.items.size() != 2) {
    reading.reader.say(node, Code::kCamchainResolution, {reading.label(key)});
    return false;
  }
  const std::optional<ImageSize> size = reading.reader.image_size(node.items[0], node.items[1], reading.owner + " ");
  if (size) reading.camera->image_size = size;
  return size.has_value();
}

constexpr Key resolution(std::string_view name) {
  Key key = schema::image_size(name);
  key.read = read_resolution;
  return key;
}

/// The frames of a camera's key; nothing of a key that it cannot have (the first one's T_cn_cnm1).
std::optional<PoseKey> frames_of(const Key& key, const std::string& camera) {
  for (const PoseKey& pose : pose_keys(camera)) {
    if (pose.key == key.name) return pose;
  }
  return std::nullopt;
}

bool read_pose(Reading& reading, const Key& key, const Node& node) {
  const std::optional<PoseKey> pose = frames_of(key, reading.camera->name);
  if (!pose) return true;
  const std::optional<Transform> T = reading.reader.transform(node, reading.label(key));
  if (T) add_pose(*pose, *T, reading.rig);
  return T.has_value();
}

std::vector<Statement> write_pose(const Subject& subject, const Key& key) {
  const std::optional<PoseKey> pose = frames_of(key, subject.the_camera().name);
  const std::optional<Transform> T = pose ? pose_in(subject.rig, pose->a, pose->b) : std::nullopt;
  if (!T) return {};
  Statement statement = {fields::rows(key.text(), *T), {}};
  const PoseEdge* edge = schema::edge_of(subject.rig, pose->a, pose->b);
  for (int i = 0; i < 16; ++i)
    statement.facts.push_back({.kind = FactKind::kPose, .pose = edge, .row = i / 4, .column = i % 4});
  return {statement};
}

constexpr Key pose(std::string_view name) { return {name, FactKind::kPose, read_pose, write_pose}; }

constexpr std::array kCameraRows = {
    Key{"camera_model", FactKind::kModel, nullptr,
        [](const Subject& subject, const Key& key) { return write_name(key, layout_of(subject).camera_model); }},
    Key{"intrinsics", FactKind::kParameter, nullptr,
        [](const Subject& subject, const Key& key) { return write_slots(subject, key, layout_of(subject).intrinsics); }},
    Key{"distortion_model", FactKind::kModel, nullptr,
        [](const Subject& subject, const Key& key) { return write_name(key, layout_of(subject).distortion_model); }},
    Key{"distortion_coeffs", FactKind::kParameter, nullptr,
        [](const Subject& subject, const Key& key) { return write_slots(subject, key, layout_of(subject).coefficients); }},
    resolution("resolution"),
    schema::camera_topic("rostopic"),
    schema::time_offset("timeshift_cam_imu"),
    pose("T_cn_cnm1"),
    pose("T_cam_imu"),
    pose("T_imu_cam"),
};

constexpr std::array kImuRows = {
    schema::imu_number("accelerometer_noise_density", &Imu::accelerometer_noise_density),
    schema::imu_number("accelerometer_random_walk", &Imu::accelerometer_random_walk),
    schema::imu_number("gyroscope_noise_density", &Imu::gyroscope_noise_density),
    schema::imu_number("gyroscope_random_walk", &Imu::gyroscope_random_walk),
    schema::imu_number("update_rate", &Imu::rate_hz),
    schema::imu_topic("rostopic"),
};

}  // namespace

constexpr schema::Mapping kCameraBlock = {.keys = kCameraRows, .unread = ""};
constexpr schema::Mapping kImuBlock = {.keys = kImuRows, .unread = ""};

namespace {

constexpr std::array kChainRows = {per_camera(schema::Spread::kNamed, schema::object("cam", kCameraBlock)),
                                   per_camera(schema::Spread::kNamedImu, schema::object("imu", kImuBlock))};

}  // namespace

constexpr schema::Schema kChain = {
    .what = "a camchain", .dialect = text::Dialect::kPyYaml, .root = {.keys = kChainRows}, .codes = {}};
constexpr schema::Schema kOpenCvChain = {
    .what = "a camchain", .dialect = text::Dialect::kOpenCv, .root = {.keys = kChainRows}, .codes = {}};

std::vector<fields::Field> camera_fields(const Rig& rig, std::size_t index, const std::optional<fields::Field>& overlaps) {
  std::vector<fields::Field> result;
  const auto add_pose = [&](std::string_view key, const std::string& to) {
    if (const std::optional<Transform> T = pose_in(rig, rig.cameras[index].name, to))
      result.push_back(fields::rows(std::string(key), *T));
  };
  add_pose("T_cam_imu", "imu0");
  if (index > 0) add_pose("T_cn_cnm1", rig.cameras[index - 1].name);
  if (overlaps) result.push_back(*overlaps);
  const std::vector<fields::Field> lens = lens_fields(rig.cameras[index]);
  result.insert(result.end(), lens.begin(), lens.end());
  return result;
}

std::vector<fields::Field> lens_fields(const Camera& camera) {
  Rig alone;
  alone.cameras = {camera};
  return schema::sorted_fields({kChain, alone}, kCameraBlock, FactKind::kPose);
}

std::vector<fields::Field> imu_fields(const Imu& imu) {
  Rig alone;
  alone.imus = {imu};
  return schema::sorted_fields({kChain, alone}, kImuBlock, FactKind::kPose);
}

std::vector<std::string> missing_in(const Imu& imu, bool rate) {
  std::vector<std::string> missing;
  for (const Key& key : kImuRows) {
    const bool wanted = key.with.imu != nullptr && (rate || key.with.imu != &Imu::rate_hz);
    if (wanted && !(imu.*key.with.imu)) missing.emplace_back(key.name);
  }
  return missing;
}

bool holds_noise(const text::Node& mapping) {
  return std::ranges::any_of(kImuRows, [&mapping](const Key& key) {
    const bool noise = key.with.imu != nullptr && key.with.imu != &Imu::rate_hz;
    return noise && text::find(mapping, key.name, text::Dialect::kPyYaml) != nullptr;
  });
}

}  // namespace fca::kalibr
