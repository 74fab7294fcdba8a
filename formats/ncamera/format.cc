// SPDX-License-Identifier: BSD-3-Clause
// ncamera YAML of SVO (uzh-rpg/rpg_svo_pro_open@372ab39, vikit_cameras: camera_yaml_serialization.cpp,
// ncamera_yaml_serialization.cpp; imu_handler.cpp) and of maplab (ethz-asl/maplab, aslam_cv2: camera.cc, ncamera.cc, sensor.cc;
// imu.cc), which read it with yaml-cpp.
//
//   label                              SVO demands one
//   id                                 32 hexadecimal digits, by which maplab tells sensors apart
//   cameras                            a list
//     camera
//       label                          the camera's name
//       line-delay-nanoseconds         rolling shutter
//       image_height, image_width
//       type, intrinsics, distortion   pinhole fx fy cx cy; maplab: unified-projection xi fx fy cx cy; SVO: omni, 24 numbers:
//                                      OCamCalib's a0 .. a4, cx, cy, c, d, e, 12 of its inverse polynomial, and a mask
//     T_B_C                            p_body = T p_camera; maplab also T_C_B. The body is the IMU
//   imu_params                         SVO: densities in continuous time; delay_imu_cam [s]: t_imu = t_cam - delay
//   imu_initialization                 tunes SVO
//
// Matrices are cols, rows, data. A distortion "fisheye" is Devernay and Faugeras' model. A camera may stand alone, without the
// list. maplab's sensors.yaml has such an ncamera as one of its sensors (sensors.cc).
#include "ncamera.h"

#include "../losses.h"
#include "../ocamcalib/ocamcalib.h"
#include "../one_camera_files.h"
#include "factory.h"
#include "lens.h"
#include "sensors.h"
#include "table.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>

namespace fca::ncamera {

using text::Node;

namespace {

constexpr text::Dialect kDialect = text::Dialect::kOpenCv;

bool has(const Node& node, std::string_view key) { return text::find(node, key, kDialect) != nullptr; }

/// A camera without a list around it.
bool is_single(const text::Document& document) {
  const Node& root = document.root();
  return !has(root, "cameras") && !has(root, "sensors") && has(root, "intrinsics") && has(root, "type");
}

std::optional<Rig> read_single(const text::Document& document, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  Camera& camera = rig.cameras.emplace_back();
  camera.name = "cam0";
  camera.image_size = options.image_size;
  fields::Reader reader(document, kDialect, diagnostics);
  schema::Reading reading{kSingle, reader, options, rig, camera.name};
  reading.camera = &camera;
  if (!schema::read_mapping(reading, kSingle.root, document.root())) return std::nullopt;
  schema::keep_unread(reading, kSingle.root, document.root(), camera.name);
  reader.warn_of_misspelt();
  return rig;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() == 1) {
    const text::Document& document = documents.front();
    if (const std::optional<Sensors> sensors = find_sensors(document))
      return read_sensors(document, *sensors, options, diagnostics);
    if (is_single(document)) return read_single(document, options, diagnostics);
    if (is_factory_file(document)) return read_factory_file(document, options, diagnostics);
  }
  return schema::read(kRig, documents, options, diagnostics);
}

const schema::Schema& table_of(const text::Document& document) {
  if (find_sensors(document)) return kSensors;
  return is_single(document) ? kSingle : kRig;
}

/// The base with what the rig says of it. Nothing where it then says another rig: a key may be missing there that a lens needs.
std::optional<text::Document> edited(const text::Document& base, const Rig& old, const Rig& rig, Written& written) {
  const schema::Schema& table = table_of(base);
  std::optional<text::Document> document;
  if (is_factory_file(base)) {
    document = base;
  } else if (const std::optional<Sensors> sensors = find_sensors(base)) {
    document = edited_sensors(base, *sensors, old, rig, written);
  } else {
    document = schema::edited(base, {table, old}, {table, rig}, written);
    if (&table == &kRig && !has(base.root(), kImuSection)) {
      const std::string more = composed_imu(rig, written);
      const std::string& bytes = base.source().bytes;
      std::string lines = bytes.ends_with('\n') ? "" : std::string(base.source().line_break());
      for (const char c : more) lines += c == '\n' ? std::string(base.source().line_break()) : std::string(1, c);
      if (!more.empty()) document->insert(bytes.size(), lines);
    }
  }
  Diagnostics ignored;
  const std::optional<text::Document> result = text::as_edited(*document);
  const std::optional<Rig> back = result ? read(std::span(&*result, 1), {}, ignored) : std::nullopt;
  const bool same = back && std::ranges::equal(back->cameras, rig.cameras, [](const Camera& a, const Camera& b) {
                      return a.name == b.name && a.model == b.model && a.image_size == b.image_size;
                    });
  return same ? std::move(document) : std::nullopt;
}

/// A file that is only read stays as it is, or a fresh one takes its place.
bool may_keep(const text::Document& base, const Rig& old, const Rig& rig) {
  return !is_factory_file(base) || (old.cameras == rig.cameras && old.imus == rig.imus && old.poses == rig.poses);
}

/// Each lens of SVO's with its inverse polynomial; one that was read with another lens is not its.
Rig with_inverses(const Rig& rig, const std::optional<Rig>& old, Written& written, Diagnostics& diagnostics) {
  Rig result = rig;
  for (const Camera& camera : rig.cameras) {
    const Camera* before = old ? old->find_camera(camera.name) : nullptr;
    const auto is_inverse = [&camera](const ExtraField& extra) {
      return extra.owner == camera.name && extra.key == ocamcalib::kInverse;
    };
    const bool is_edited = before != nullptr && has_same_polynomial(before->model, camera.model);
    if (before != nullptr && !is_edited) std::erase_if(result.extra_fields, is_inverse);
    std::optional<ExtraField> inverse = inverse_of(result, camera, is_edited, written, diagnostics);
    std::erase_if(result.extra_fields, is_inverse);
    if (inverse) result.extra_fields.push_back(*std::move(inverse));
  }
  return result;
}

bool has_any(const Rig& rig, std::string_view model) {
  return std::ranges::any_of(rig.cameras, [model](const Camera& camera) { return model_info(camera.model).id == model; });
}

/// Who reads a fresh file with these lenses.
std::string_view readers_of(const Rig& rig) {
  if (has_any(rig, "mei")) return "maplab";
  return has_any(rig, "ocamcalib") ? "SVO" : "SVO and maplab";
}

std::vector<std::string> programs_of(const text::Document& document, const Rig& rig) {
  if (find_sensors(document)) return {"maplab"};
  if (is_factory_file(document) || is_single(document)) return {};
  if (has_any(rig, "mei")) return {"maplab"};
  return {"svo"};
}

/// What only some layouts have a place for.
void list_losses(const schema::Schema& table, Rig rig, Written& written) {
  const Message no_place{Code::kFilesHaveNoPlace, {table.program}};
  if (&table == &kSensors) {
    for (Imu& imu : rig.imus) imu.topic.clear();
    if (!rig.imus.empty() && rig.imus.front().rate_hz) {
      written.losses.push_back(lost(Code::kNotCarriedValue, rig.imus.front().name, "rate",
                                    {no_place, text::format_short(*rig.imus.front().rate_hz)}));
    }
  }
  schema::list_losses(table, rig, no_place, written.losses);
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const bool may_edit = there && !options.rewrite && schema::same_cameras(*there, rig) && may_keep(*base, *there, rig);
  if (may_edit ? !can_store(kFormat, rig, &*there, diagnostics)
               : !writable_alone(kFormat, rig, Message{Code::kTableDemandsSize}, diagnostics))
    return std::nullopt;

  Written written;
  Diagnostics found;
  std::optional<text::Document> document;
  if (may_edit) document = edited(*base, *there, with_inverses(rig, there, written, found), written);
  const bool edits = document.has_value();
  if (!edits) {
    if (may_edit && !writable_alone(kFormat, rig, Message{Code::kTableDemandsSize}, diagnostics)) return std::nullopt;
    written = {};
    found = {};
    document =
        text::parse_document({"ncamera.yaml", composed(with_inverses(rig, there, written, found), written)}, diagnostics);
  }
  if (!document) return std::nullopt;
  for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
  const schema::Schema& table = edits ? table_of(*base) : kRig;
  std::vector<std::string> programs = programs_of(*document, rig);
  written.files.push_back({*std::move(document), {}, std::move(programs)});
  for (const Camera& camera : rig.cameras) written.files.front().cameras.push_back(camera.name);
  add_extras_lost(rig, edits ? there->extra_fields : carried(rig), edits ? std::nullopt : there,
                  Message{Code::kFilesHaveNoPlace, {table.program}}, written.losses);
  list_losses(table, rig, written);
  written.headline = {Code::kTableWrote, {"an ncamera", edits ? table.program : readers_of(rig)}};
  return written;
}

ProbeResult probe(const text::Document& document) {
  const auto found = [](std::string_view a, std::string_view b) {
    return Message{Code::kFoundKeys, {std::vector<std::string>{std::string(a), std::string(b)}}};
  };
  const Node& root = document.root();
  if (const std::optional<Sensors> sensors = find_sensors(document)) {
    if (sensors->cameras != nullptr) return {evidence::kCamera, found("sensors", "NCAMERA")};
    return sensors->imu != nullptr ? ProbeResult{evidence::kPart, found("sensors", "IMU")} : ProbeResult{};
  }
  if (is_single(document) && has(root, "distortion") && has(root, "image_width"))
    return {evidence::kCamera, found("intrinsics", "distortion")};
  if (is_factory_file(document)) return {evidence::kCamera, found("cam_model", "cam_fx")};
  const Node* cameras = text::find(root, "cameras", kDialect);
  if (cameras == nullptr) return {};
  for (const Node& item : cameras->items) {
    const Node* camera = text::find(item, "camera", kDialect);
    for (const std::string_view key : {"intrinsics", "distortion"}) {
      if (camera != nullptr && has(*camera, key)) return {evidence::kCamera, found("cameras", key)};
    }
    for (const std::string_view key : {"T_B_C", "T_C_B"}) {
      if (has(item, key)) return {evidence::kHint, found("cameras", key)};
    }
  }
  return {};
}

constexpr std::string_view kBoth = "SVO, maplab";
constexpr std::array kNoK3 = {ParameterRange{"k3", 0.0, 0.0}};
constexpr std::array kDegreeFour = {ParameterRange{"a5", 0.0, 0.0}, ParameterRange{"a6", 0.0, 0.0},
                                    ParameterRange{"a7", 0.0, 0.0}, ParameterRange{"a8", 0.0, 0.0}};
constexpr std::array kModels = {
    StoredModel{"radtan", "pinhole, radial-tangential", true, kBoth, kNoK3},
    StoredModel{"kb4", "pinhole, equidistant", true, kBoth, {}},
    StoredModel{"fov", "pinhole, fisheye", true, kBoth, {}},
    StoredModel{"pinhole", "pinhole, none", true, kBoth, {}},
    StoredModel{"ocamcalib", "omni", true, "SVO", kDegreeFour},
    StoredModel{"mei", "unified-projection, radial-tangential", false, "maplab", {}},
};
constexpr std::array<std::string_view, 1> kInverse = {ocamcalib::kInverse};
constexpr std::array kOwnFacts = {OwnFact{"ids, labels, rolling shutter, tuning, other sensors"},
                                  OwnFact{"the inverse polynomial", kInverse}};
constexpr std::array<std::string_view, 2> kOfTheImages = {kMask, "line-delay-nanoseconds"};
constexpr std::array kDemands = {
    Demand{"pose in the IMU", "T_B_C"},
    Demand{"a label and ids", "label"},
    Demand{"a label and ids", "id"},
    Demand{"SVO's tuning", "tuning (", &Format::imu},
    // The time offset stands among the IMU's numbers.
    Demand{"SVO's tuning", "tuning (", &Format::time_offset},
    Demand{"IMU noise and rate", "IMU ", &Format::time_offset, &Format::imu},
    Demand{.name = "inverse polynomial (fitted)", .key = "inverse polynomial", .of_model = "ocamcalib"},
};

}  // namespace

const Format kFormat = {
    .id = "ncamera",
    .title = "ncamera (SVO, maplab)",
    .group = FormatGroup::kSlam,
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = "SVO",
    .main_file = "ncamera.yaml",
    .many_cameras = true,
    .extrinsics = true,
    .imu = true,
    .image_size = true,
    .time_offset = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .of_the_images = kOfTheImages,
    .models = kModels,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::ncamera
