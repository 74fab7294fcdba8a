// SPDX-License-Identifier: BSD-3-Clause
#include "sensors.h"

#include "table.h"

#include <fca/code.h>

#include <algorithm>
#include <array>
#include <string>

namespace fca::ncamera {

using text::Node;

namespace {

/// The frame of an NCAMERA that does not sit where the IMU does.
constexpr std::string_view kBody = "ncamera";
constexpr text::Dialect kDialect = text::Dialect::kOpenCv;

std::string word_at(const Node& node, std::string_view key) {
  const Node* value = text::find(node, key, kDialect);
  return value != nullptr ? value->value : "";
}

std::string word_at(const fields::Reader& reader, const Node& node, std::string_view key) {
  const Node* value = reader.find(node, key);
  return value != nullptr ? value->value : "";
}

/// T_base_sensor of the list "extrinsics".
struct Extrinsic {
  std::string base;
  const Node* matrix = nullptr;  ///< Null: the list says none.
  const Node* pose = nullptr;    ///< That holds it.
};

Extrinsic extrinsic_of(const fields::Reader& reader, const std::string& id) {
  const Node* list = reader.find(reader.document().root(), "extrinsics");
  if (list == nullptr) return {};
  for (const Node& entry : list->items) {
    if (word_at(reader, entry, "sensor_id") != id) continue;
    const Node* pose = reader.find(entry, "T_B_S");
    return {word_at(reader, entry, "base_sensor_id"), pose != nullptr ? reader.find(*pose, "data") : nullptr, pose};
  }
  return {};
}

/// How the list says that the NCAMERA sits to the IMU.
enum class Link { kSame, kPose, kUnknown };

struct Body {
  Link link = Link::kUnknown;
  Transform T_imu_body = {};
};

/// Nothing, with errors, where a pose cannot be read. A file without the list has one body: the IMU.
std::optional<Body> body_of(fields::Reader& reader, const Sensors& sensors) {
  const bool has_list = reader.find(reader.document().root(), "extrinsics") != nullptr;
  if (sensors.imu == nullptr || !has_list) return Body{Link::kSame, {}};
  const std::string imu_id = word_at(*sensors.imu, "id");
  const Extrinsic cameras = extrinsic_of(reader, word_at(*sensors.cameras, "id"));
  const Extrinsic imu = extrinsic_of(reader, imu_id);
  if (cameras.matrix == nullptr) return Body{};
  const std::optional<Transform> T_base_body = reader.transform(*cameras.matrix, "T_B_S of the NCAMERA");
  std::optional<Transform> T_base_imu = Transform{};
  if (cameras.base != imu_id) {
    if (imu.matrix == nullptr || imu.base != cameras.base) return Body{};
    T_base_imu = reader.transform(*imu.matrix, "T_B_S of the IMU");
  }
  if (!T_base_body || !T_base_imu) return std::nullopt;
  const std::optional<Transform> T_imu_base = inverse(*T_base_imu);
  if (!T_imu_base) return Body{};
  const Transform T = *T_imu_base * *T_base_body;
  return Body{T == Transform{} ? Link::kSame : Link::kPose, T};
}

void rename(Rig& rig, const std::string& from, const std::string& to) {
  for (PoseEdge& pose : rig.poses) {
    if (pose.a == from) pose.a = to;
    if (pose.b == from) pose.b = to;
  }
}

/// The poses that the NCAMERA specifies are in its own frame.
void set_body(Rig& rig, const Body& body) {
  if (body.link == Link::kSame) return;
  rename(rig, std::string(schema::kImu), std::string(kBody));
  std::erase_if(rig.frames, [](const Frame& frame) { return frame.name == schema::kImu; });
  rig.add_frame(kBody, FrameKind::kOther);
  if (body.link == Link::kPose) rig.poses.push_back({std::string(schema::kImu), std::string(kBody), body.T_imu_body});
}

/// The same rig as its NCAMERA specifies it: the poses of the cameras in the NCAMERA, which is called as an IMU is.
Rig in_body(Rig rig) {
  if (rig.kind_of(kBody) != FrameKind::kOther || std::ranges::find(rig.frames, kBody, &Frame::name) == rig.frames.end())
    return rig;
  std::vector<PoseEdge> poses;
  const std::string imu = rig.imus.empty() ? std::string(schema::kImu) : rig.imus.front().name;
  for (const Camera& camera : rig.cameras) {
    if (const Transform* turned = rig.stated(camera.name, kBody)) {
      poses.push_back({camera.name, imu, *turned});
    } else if (const std::optional<Transform> T = rig.resolve(kBody, camera.name)) {
      const Transform* stated = rig.stated(kBody, camera.name);
      poses.push_back({imu, camera.name, stated != nullptr ? *stated : *T});
    }
  }
  rig.poses = std::move(poses);
  return rig;
}

/// One sensor's keys; false with errors where one cannot be read.
bool read_sensor(schema::Reading& reading, const schema::Mapping& mapping, const Node& node, const std::string& owner) {
  if (!schema::read_mapping(reading, mapping, node)) return false;
  schema::keep_unread(reading, mapping, node, owner);
  return true;
}

void keep_others(Rig& rig, const Sensors& sensors) {
  for (const Node* other : sensors.others) {
    const std::string type = word_at(*other, "sensor_type");
    rig.extra_fields.push_back(
        {"", (type.empty() ? "sensor" : type) + " " + word_at(*other, "id"), fields::value_text(*other)});
  }
}

}  // namespace

std::optional<Sensors> find_sensors(const text::Document& document) {
  const Node* list = text::find(document.root(), "sensors", kDialect);
  if (list == nullptr || !list->is_sequence()) return std::nullopt;
  Sensors sensors;
  for (const Node& sensor : list->items) {
    const std::string type = word_at(sensor, "sensor_type");
    if (type == "NCAMERA" && sensors.cameras == nullptr) {
      sensors.cameras = &sensor;
    } else if (type == "IMU" && sensors.imu == nullptr) {
      sensors.imu = &sensor;
    } else {
      sensors.others.push_back(&sensor);
    }
  }
  return sensors;
}

std::optional<Rig> read_sensors(const text::Document& document, const Sensors& sensors, const ReadOptions& options,
                                Diagnostics& diagnostics) {
  fields::Reader reader(document, kDialect, diagnostics);
  if (sensors.cameras == nullptr) {
    reader.say(*text::find(document.root(), "sensors", kDialect), Code::kTableNoCameraList, {"sensors"});
    return std::nullopt;
  }
  for (const Node& sensor : text::find(document.root(), "sensors", kDialect)->items) (void)reader.find(sensor, "sensor_type");
  Rig rig;
  schema::Reading reading{kSensors, reader, options, rig, ""};
  if (!read_sensor(reading, kSensorOfCameras, *sensors.cameras, "")) return std::nullopt;
  if (sensors.imu != nullptr) {
    Imu imu;
    schema::Reading of_imu{kSensors, reader, options, rig, imu.name};
    of_imu.imu = &imu;
    if (!read_sensor(of_imu, kSensorOfImu, *sensors.imu, imu.name)) return std::nullopt;
    rig.imus.push_back(std::move(imu));
  }
  const std::optional<Body> body = body_of(reader, sensors);
  if (!body || reader.diagnostics().has_errors()) return std::nullopt;
  if (body->link == Link::kUnknown)
    reader.say(Severity::kWarning, *sensors.cameras, Code::kKeyMissing, {"extrinsics", "T_B_S of the NCAMERA and the IMU"});
  set_body(rig, *body);
  keep_others(rig, sensors);
  reader.warn_of_misspelt();
  return rig;
}

namespace {

/// Where the NCAMERA sits to the IMU, in the list.
void edit_body(text::Document& document, const Sensors& sensors, const Transform& was, const Transform& now) {
  Diagnostics ignored;
  fields::Reader reader(document, kDialect, ignored);
  const Extrinsic cameras = extrinsic_of(reader, word_at(*sensors.cameras, "id"));
  if (was == now || cameras.pose == nullptr || sensors.imu == nullptr) return;
  Transform T_base_imu;
  if (const std::string imu_id = word_at(*sensors.imu, "id"); cameras.base != imu_id) {
    const Extrinsic imu = extrinsic_of(reader, imu_id);
    const std::optional<Transform> stated =
        imu.matrix != nullptr ? reader.transform(*imu.matrix, "T_B_S of the IMU") : std::nullopt;
    if (!stated) return;
    T_base_imu = *stated;
  }
  const auto field = [&T_base_imu](const Transform& T) { return std::array{fields::rows("data", T_base_imu * T)}; };
  fields::apply(document, *cameras.pose, kDialect, field(was), field(now));
}

}  // namespace

text::Document edited_sensors(const text::Document& base, const Sensors& sensors, const Rig& old, const Rig& rig,
                              Written& written) {
  text::Document document = base;
  const Rig before = in_body(old);
  Rig framed = rig;
  for (const Frame& frame : old.frames) {
    if (frame.name == kBody) framed.add_frame(frame.name, frame.kind);
  }
  const Transform* body = old.stated(schema::kImu, kBody);
  if (body != nullptr && !framed.resolve(schema::kImu, kBody))
    framed.poses.push_back({std::string(schema::kImu), std::string(kBody), *body});
  const Rig after = in_body(framed);
  schema::edit(document, kSensorOfCameras, *sensors.cameras, {kSensors, before}, {kSensors, after}, written);
  if (sensors.imu != nullptr && !rig.imus.empty())
    schema::edit(document, kSensorOfImu, *sensors.imu, {kSensors, before}, {kSensors, after}, written);
  if (const std::optional<Transform> now = framed.resolve(schema::kImu, kBody); body != nullptr && now)
    edit_body(document, sensors, *body, *now);
  return document;
}

}  // namespace fca::ncamera
