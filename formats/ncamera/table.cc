// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include "../ocamcalib/ocamcalib.h"
#include "lens.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>

namespace fca::ncamera {

using schema::FactKind;
using schema::Key;
using schema::required;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

constexpr std::string_view kLabel = "label";
constexpr std::string_view kId = "id";
constexpr std::string_view kLineDelay = "line-delay-nanoseconds";
constexpr std::string_view kProgram = "SVO";

/// A name that another camera has is none.
bool read_label(schema::Reading& reading, const Key& key, const Node& node) {
  const std::string name = reading.reader.name(node, reading.label(key));
  const bool taken = reading.rig.find_camera(name) != nullptr;
  if (!name.empty() && !taken) reading.camera->name = name;
  if (taken && reading.camera->name != name) reading.rig.extra_fields.push_back({reading.camera->name, key.text(), name});
  return true;
}

std::vector<Statement> write_label(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  return schema::states(fields::quoted(key.text(), subject.the_camera().name));
}

constexpr std::size_t kIdLength = 32;

bool is_id(std::string_view text) {
  return text.size() == kIdLength && text.find_first_not_of("0123456789abcdef") == std::string_view::npos &&
         text.find_first_not_of('0') != std::string_view::npos;
}

/// FNV-1a: an id that is another's for another name, and the same whenever the file is written.
std::string made_up_id(std::string_view of) {
  std::string id;
  std::uint64_t hash = 14695981039346656037ULL;
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (int half = 0; half < 2; ++half) {
    for (const char c : of) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    for (int shift = 60; shift >= 0; shift -= 4) id += kDigits[(hash >> static_cast<unsigned>(shift)) & 15U];
  }
  return id;
}

/// That which the rig keeps for a sensor ("": the ncamera), if no other has the same.
const ExtraField* kept_id(const Rig& rig, std::string_view owner) {
  const ExtraField* kept = rig.find_extra_field(owner, kId);
  if (kept == nullptr || !is_id(kept->value)) return nullptr;
  const auto same = [kept](const ExtraField& extra) { return extra.key == kId && extra.value == kept->value; };
  return std::ranges::count_if(rig.extra_fields, same) == 1 ? kept : nullptr;
}

std::string id_for(const Subject& subject, const std::string& owner) {
  if (const ExtraField* kept = kept_id(subject.rig, owner)) return kept->value;
  const std::string key = (owner.empty() ? "" : owner + " ") + std::string(kId);
  subject.fresh->defaults.push_back({key, Message{Code::kTableMadeUpId, {"maplab"}}, false, false});
  return made_up_id("fca-io " + owner + " " + std::to_string(owner.empty() ? subject.rig.cameras.size() : subject.camera));
}

std::vector<Statement> write_id(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  return schema::states(fields::scalar(key.text(), id_for(subject, subject.the_camera().name)));
}

/// Zero says nothing.
bool read_line_delay(schema::Reading& reading, const Key& key, const Node& node) {
  const std::optional<double> delay = reading.reader.real(node, reading.label(key));
  if (delay && *delay != 0.0) reading.rig.extra_fields.push_back({reading.camera->name, key.text(), node.value});
  return delay.has_value();
}

std::vector<Statement> write_line_delay(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  const ExtraField* kept = subject.rig.find_extra_field(subject.the_camera().name, kLineDelay);
  const bool number = kept != nullptr && text::parse_real(kept->value);
  return schema::states(fields::scalar(key.text(), number ? kept->value : "0"));
}

/// T_body_camera; SVO's body is the IMU.
constexpr schema::PoseLayout kPoseInImu = {.frame = schema::kImu,
                                           .kind = FrameKind::kImu,
                                           .translation = {},
                                           .rotation = {},
                                           .in_frame = Code::kTablePoseInFrame,
                                           .identity = Code::kTableIdentity};

void collect(const Node& node, std::vector<double>& numbers) {
  if (node.is_scalar()) numbers.push_back(text::parse_real(node.value).value_or(1.0));
  for (const Node& item : node.items) collect(item, numbers);
}

/// 16 numbers, or four rows of them. The programs do not read the last row, which real files have as zeros.
std::optional<Transform> read_transform(schema::Reading& reading, const Key& key, const Node& node) {
  std::vector<double> numbers;
  collect(node, numbers);
  Transform T;
  const std::size_t last_row = T.values.size() - 4;
  const bool zeros = numbers.size() == T.values.size() && std::all_of(numbers.begin() + static_cast<std::ptrdiff_t>(last_row),
                                                                      numbers.end(), [](double n) { return n == 0.0; });
  if (!zeros) return reading.reader.transform(node, reading.label(key));
  reading.reader.say(Severity::kWarning, node, Code::kLastRowWrong, {reading.label(key)});
  std::copy_n(numbers.begin(), last_row, T.values.begin());
  return reading.reader.checked(T, node, reading.label(key));
}

bool read_body_from_camera(schema::Reading& reading, const Key& key, const Node& node) {
  const std::optional<Transform> T = read_transform(reading, key, node);
  if (!T) return false;
  reading.rig.poses.push_back({std::string(schema::kImu), reading.camera->name, *T});
  reading.rig.add_frame(schema::kImu, FrameKind::kImu);
  return true;
}

bool read_camera_from_body(schema::Reading& reading, const Key& key, const Node& node) {
  const std::optional<Transform> T = read_transform(reading, key, node);
  if (!T) return false;
  reading.rig.poses.push_back({reading.camera->name, std::string(schema::kImu), *T});
  reading.rig.add_frame(schema::kImu, FrameKind::kImu);
  return true;
}

/// No fresh file has it.
std::vector<Statement> write_camera_from_body(const Subject& subject, const Key& key) {
  if (subject.fresh != nullptr) return {};
  const std::string& camera = subject.the_camera().name;
  const std::string imu = subject.rig.imus.empty() ? std::string(schema::kImu) : subject.rig.imus.front().name;
  const Transform* stated = subject.rig.stated(camera, imu);
  const std::optional<Transform> T = stated != nullptr ? *stated : subject.rig.resolve(camera, imu);
  if (!T) return {};
  return {{fields::list(key.text(), T->values), {}}};
}

constexpr std::array kBodyFromCameraKeys = {
    schema::side_of_four("cols"), schema::side_of_four("rows"),
    required(
        Key{"data", FactKind::kPose, read_body_from_camera, schema::write_matrix, {.pose = &kPoseInImu, .other = "T_B_C"}})};
constexpr schema::Mapping kBodyFromCamera = {.keys = kBodyFromCameraKeys};
constexpr std::array kCameraFromBodyKeys = {
    schema::side_of_four("cols"), schema::side_of_four("rows"),
    required(Key{"data", FactKind::kPose, read_camera_from_body, write_camera_from_body})};
constexpr schema::Mapping kCameraFromBody = {.keys = kCameraFromBodyKeys};
constexpr std::array kPoseKeys = {schema::object("T_B_C", kBodyFromCamera),
                                  schema::only_edited(schema::object("T_C_B", kCameraFromBody))};

constexpr std::array kCameraKeys = {
    Key{kLabel, FactKind::kOther, read_label, write_label},
    Key{kId, FactKind::kOther, schema::keep, write_id},
    schema::camera_topic("topic"),
    schema::unread("sensor_type"),
    Key{kLineDelay, FactKind::kOther, read_line_delay, write_line_delay},
    required(schema::image_width("image_width", false)),
    required(schema::image_height("image_height", "image_width", false)),
    required(Key{"type", FactKind::kModel, read_lens, write_type}),
    required(schema::object("intrinsics", kIntrinsics)),
    schema::object("distortion", kDistortion),
};
constexpr schema::Mapping kCamera = {.keys = kCameraKeys, .unread = "", .warns_of_duplicates = true, .stops_at_error = true};

template <std::size_t kFirst, std::size_t kSecond>
constexpr std::array<Key, kFirst + kSecond> joined(const std::array<Key, kFirst>& first,
                                                   const std::array<Key, kSecond>& second) {
  std::array<Key, kFirst + kSecond> keys{};
  std::ranges::copy(second, std::ranges::copy(first, keys.data()).out);
  return keys;
}

constexpr std::array kCameraEntry = {required(schema::object("camera", kCamera))};
constexpr auto kItemKeys = joined(kCameraEntry, kPoseKeys);
constexpr schema::Mapping kItem = {.keys = kItemKeys, .unread = "", .warns_of_duplicates = true, .stops_at_error = true};

/// The camera's own keys name it, before its pose and what nobody reads are said of it.
bool read_item(schema::Reading& reading, const Key& key, const Node& node) {
  if (!schema::read_object(reading, key, node)) return false;
  schema::keep_unread(reading, kItem, node, reading.camera->name);
  return true;
}

constexpr Key kCameras = required(
    schema::per_camera(schema::Spread::kCounted, Key{"cameras", FactKind::kOther, read_item, nullptr, {.mapping = &kItem}}));

/// Noise and tuning begin as the file of the program's README has them.
constexpr Key tuning(std::string_view name, std::string_view token) { return schema::tuning(name, kTuningPrefix, token); }
constexpr std::array kImuKeys = {
    schema::common_delay("delay_imu_cam"),
    tuning("max_imu_delta_t", "0.01"),
    tuning("acc_max", "176.0"),
    tuning("omega_max", "7.8"),
    schema::imu_number("sigma_omega_c", &Imu::gyroscope_noise_density, 0.005),
    schema::imu_number("sigma_acc_c", &Imu::accelerometer_noise_density, 0.01),
    schema::imu_number("sigma_omega_bias_c", &Imu::gyroscope_random_walk, 4.0e-6),
    schema::imu_number("sigma_acc_bias_c", &Imu::accelerometer_random_walk, 0.0002),
    tuning("sigma_integration", "0.0"),
    tuning("g", "9.81007"),
    schema::imu_number("imu_rate", &Imu::rate_hz, 200.0),
};
constexpr schema::Mapping kImu = {.keys = kImuKeys, .unread = kTuningPrefix};
constexpr std::array kStartKeys = {tuning("velocity", "[0.0, 0.0, 0.0]"), tuning("omega_bias", "[0.0, 0.0, 0.0]"),
                                   tuning("acc_bias", "[0.0, 0.0, 0.0]"), tuning("velocity_sigma", "0.5"),
                                   tuning("omega_bias_sigma", "0.005"),   tuning("acc_bias_sigma", "0.05")};
constexpr schema::Mapping kStart = {.keys = kStartKeys, .unread = kTuningPrefix};
constexpr std::array kSections = {schema::object(kImuSection, kImu), schema::object("imu_initialization", kStart)};

constexpr std::array kRigHead = {kCameras};
constexpr auto kRigKeys = joined(kRigHead, kSections);
constexpr auto kSingleKeys = joined(kCameraKeys, kPoseKeys);

// maplab's sensors.
constexpr std::array kSensorKeys = {kCameras, schema::unread("sensor_type"), schema::unread("topic")};
constexpr std::array kSigmaKeys = {schema::imu_number("gyro_noise_density", &Imu::gyroscope_noise_density),
                                   schema::imu_number("gyro_bias_random_walk_noise_density", &Imu::gyroscope_random_walk),
                                   schema::imu_number("acc_noise_density", &Imu::accelerometer_noise_density),
                                   schema::imu_number("acc_bias_random_walk_noise_density", &Imu::accelerometer_random_walk)};
constexpr schema::Mapping kSigmas = {.keys = kSigmaKeys, .unread = ""};
constexpr std::array kSensorImuKeys = {schema::unread("sensor_type"), schema::imu_topic("topic"),
                                       schema::object("sigmas", kSigmas)};
constexpr std::array kSensorsKeys = {kCameras, schema::object("sigmas", kSigmas)};

constexpr schema::Schema schema_of(const schema::Mapping& root, std::string_view program) {
  return {.what = "an ncamera",
          .dialect = text::Dialect::kOpenCv,  // of keys that stand twice yaml-cpp, too, takes the first
          .root = root,
          .codes = {.wrong_syntax = Code::kTableWrongSyntax,
                    .no_object = Code::kTableNoObject,
                    .no_camera_list = Code::kTableNoCameraList,
                    .not_four = Code::kTableSideNotFour,
                    .initial_value = Code::kTableInitialValue,
                    .one_offset = Code::kTableOneOffset,
                    .further_imu = Code::kTableFurtherImu},
          .program = program};
}

/// Does a fresh file have SVO's sections?
bool has_imu(const Rig& rig) {
  return !rig.imus.empty() ||
         std::ranges::any_of(rig.cameras, [](const Camera& camera) { return camera.time_offset_s.value_or(0.0) != 0.0; });
}

}  // namespace

constinit const schema::Schema kRig = schema_of({.keys = kRigKeys, .unread = "", .warns_of_duplicates = true}, kProgram);
constinit const schema::Schema kSingle =
    schema_of({.keys = kSingleKeys, .unread = "", .warns_of_duplicates = true, .stops_at_error = true}, kProgram);
constinit const schema::Schema kSensors = schema_of({.keys = kSensorsKeys}, "maplab");
constinit const schema::Mapping kSensorOfCameras = {.keys = kSensorKeys, .unread = "", .warns_of_duplicates = true};
constinit const schema::Mapping kSensorOfImu = {.keys = kSensorImuKeys, .unread = "", .warns_of_duplicates = true};

std::string composed_imu(const Rig& rig, Written& written) {
  if (!has_imu(rig)) return "";
  Written made_up;
  const Subject subject{.schema = kRig, .rig = rig, .fresh = &made_up};
  std::string text;
  for (const Key& section : kSections)
    text += "\n" + section.text() + ":\n" + schema::yaml_lines(subject, *section.with.mapping, 2, 2);
  bool tuned = false;
  for (DefaultedValue& value : made_up.defaults) {
    tuned = tuned || !value.invented;
    value.key = "IMU " + value.key;
    if (value.invented) written.defaults.push_back(std::move(value));
  }
  if (tuned) {
    written.defaults.push_back(
        {"tuning (imu_params, imu_initialization)", Message{Code::kTableStockValue, {kProgram}}, false, false});
  }
  return text;
}

std::string composed(const Rig& rig, Written& written) {
  Subject subject{.schema = kRig, .rig = rig, .fresh = &written};
  const ExtraField* label = rig.find_extra_field("", kLabel);
  if (label == nullptr) written.defaults.push_back({std::string(kLabel), "cameras", false, false});
  std::string text = fields::spell(fields::quoted(std::string(kLabel), label != nullptr ? label->value : "cameras")) + "\n";
  text += fields::spell(fields::scalar(std::string(kId), id_for(subject, ""))) + "\ncameras:\n";
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    subject.camera = i;
    std::string lines = schema::yaml_lines(subject, kItem, 2, 2);
    lines[0] = '-';
    text += lines;
  }
  return text + composed_imu(rig, written);
}

std::vector<ExtraField> carried(const Rig& rig) {
  std::vector<ExtraField> result;
  if (const ExtraField* label = rig.find_extra_field("", kLabel)) result.push_back(*label);
  if (const ExtraField* id = kept_id(rig, "")) result.push_back(*id);
  for (const Camera& camera : rig.cameras) {
    if (const ExtraField* id = kept_id(rig, camera.name)) result.push_back(*id);
    for (const std::string_view key : {kLineDelay, kMask, ocamcalib::kInverse}) {
      const ExtraField* kept = rig.find_extra_field(camera.name, key);
      const bool of_omni = key == kLineDelay || model_info(camera.model).id == "ocamcalib";
      if (kept != nullptr && of_omni) result.push_back(*kept);
    }
  }
  for (const Key& section : kSections) {
    for (const Key& key : section.with.mapping->keys) {
      const bool is_tuning = has_imu(rig) && !key.with.token.empty();
      const ExtraField* kept = is_tuning ? schema::kept_tuning(rig, key) : nullptr;
      if (kept != nullptr) result.push_back(*kept);
    }
  }
  return result;
}

}  // namespace fca::ncamera
