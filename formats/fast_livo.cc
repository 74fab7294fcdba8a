// SPDX-License-Identifier: BSD-3-Clause
// The camera of FAST-LIVO and FAST-LIVO2 (camera_pinhole.yaml), parameters of ROS for rpg_vikit's camera_loader.h
// (xuankuzcr/rpg_vikit@6c886c8 of 2025-03).
//
//   cam_model             Pinhole, EquidistantCamera or ATAN
//   cam_width, cam_height of the images as they come
//   scale                 what the program shrinks them by; it multiplies all lengths (1.0, if it is missing; ATAN has none)
//   cam_fx, cam_fy, cam_cx, cam_cy   [px]; of ATAN shares of the width and height: fx w, fy h, cx w - 0.5, cy h - 0.5
//   cam_d0 .. cam_d3      Pinhole: k1 k2 p1 p2 as OpenCV has them; ATAN: cam_d0 is the angle of the FOV model
//   k1 .. k4              EquidistantCamera: cv::fisheye's
//
// A coefficient that is missing is 0. Two models of the program have none of ours: PolynomialCamera (theta + k2 theta^2 + ...
// + k7 theta^7, and a skew) and Ocam, whose numbers stand in a file of OCamCalib's.
//
// In a file of ROS 2 all stands below ros__parameters, and below the name of the camera there. Where the camera sits, its time
// offset and topic stand in another file (avia.yaml).
#include "fast_livo.h"

#include "losses.h"
#include "one_camera_files.h"
#include "schema/keys.h"

#include <fca/code.h>
#include <fca/formats/file_name.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fca::fast_livo {

using schema::FactKind;
using schema::Key;
using schema::Reading;
using schema::required;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

constexpr std::string_view kProgram = "FAST-LIVO";
constexpr std::string_view kModelKey = "cam_model";
constexpr std::size_t kShown = 40;  ///< Of a word of the file, in a message.

/// A lens of the program's. The first row of a model is the one that is written.
struct Lens {
  std::string_view name;
  std::string_view model;
};
constexpr std::array kLenses = {Lens{"Pinhole", "radtan"}, Lens{"EquidistantCamera", "kb4"}, Lens{"ATAN", "fov"},
                                Lens{"Pinhole", "pinhole"}};

std::string_view id_of(const Camera& camera) { return model_info(camera.model).id; }

std::string_view name_of(const CameraModel& model) {
  const auto* const found = std::ranges::find(kLenses, model_info(model).id, &Lens::model);
  return found == kLenses.end() ? std::string_view() : found->name;
}

bool read_lens(Reading& reading, const Key& key, const Node& node) {
  struct Other {
    std::string_view name;
    Code why;
  };
  constexpr std::array kOthers = {Other{"PolynomialCamera", Code::kSlamNotAllPowers}, Other{"Ocam", Code::kSlamInCalibResults}};
  const auto* const lens = std::ranges::find(kLenses, node.value, &Lens::name);
  if (lens != kLenses.end()) {
    reading.camera->model = make_model(lens->model).value();
    return true;
  }
  if (const auto* const other = std::ranges::find(kOthers, node.value, &Other::name); other != kOthers.end()) {
    reading.reader.say(node, Code::kSlamModelNotRead, {kProgram, node.value, Message{other->why}});
  } else {
    const std::vector<std::string> known = {"Pinhole", "EquidistantCamera", "ATAN"};
    reading.reader.say(node, Code::kTableUnknownWord, {key.name, node.value.substr(0, kShown), known});
  }
  return false;
}

std::vector<Statement> write_lens(const Subject& subject, const Key& key) {
  return schema::states(fields::scalar(key.text(), std::string(name_of(subject.the_camera().model))), {FactKind::kModel});
}

/// The side of the image of which ATAN's number is a share, and how far the share's origin, the image's border, is from ours.
struct Share {
  double side = 1.0;
  double shift = 0.0;
};
Share share_of(const Camera& camera, ParameterId id) {
  if (id_of(camera) != "fov") return {};
  const ImageSize size = camera.image_size.value_or(ImageSize{1, 1});
  const bool along_width = id == ParameterId("fx") || id == ParameterId("cx");
  const bool of_centre = id == ParameterId("cx") || id == ParameterId("cy");
  return {static_cast<double>(along_width ? size.width : size.height), of_centre ? 0.5 : 0.0};
}

double to_pixels(double number, const Share& share) { return number * share.side - share.shift; }

/// The number that reads back as exactly `value` where there is one, else the nearest.
double from_pixels(double value, const Share& share) {
  const double number = (value + share.shift) / share.side;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double below = number;
  double above = number;
  constexpr int kNeighbours = 3;
  for (int i = 0; i < kNeighbours; ++i) {
    if (to_pixels(below, share) == value) return below;
    if (to_pixels(above, share) == value) return above;
    below = std::nextafter(below, -kInfinity);
    above = std::nextafter(above, kInfinity);
  }
  return number;
}

bool read_length(Reading& reading, const Key& key, const Node& node) {
  Camera& camera = *reading.camera;
  const ParameterId id = key.with.parameter.value();
  const std::optional<double> number = reading.reader.real(node, reading.label(key));
  return number &&
         reading.reader.parameter(node, reading.label(key), id, to_pixels(*number, share_of(camera, id)), camera.model);
}

std::vector<Statement> write_length(const Subject& subject, const Key& key) {
  const Camera& camera = subject.the_camera();
  const ParameterId id = key.with.parameter.value();
  const double value = parameter(camera.model, id).value();
  return schema::states(fields::real(key.text(), from_pixels(value, share_of(camera, id))),
                        {.kind = FactKind::kParameter, .parameter = id.name()});
}

constexpr Key length(std::string_view name, ParameterId id) {
  return {name, FactKind::kParameter, read_length, write_length, {.parameter = id}};
}

/// Which parameter of the camera's model the key specifies; nothing: the program does not read it next to that model.
std::optional<ParameterId> stated_by(const Key& key, const Camera& camera) {
  const bool of_fisheye = key.name.starts_with('k');
  const std::string_view id = id_of(camera);
  if (id == "fov") return key.name == "cam_d0" ? std::optional(ParameterId("w")) : std::nullopt;
  if ((id == "kb4") != of_fisheye) return std::nullopt;
  return key.with.parameter;
}

bool read_coefficient(Reading& reading, const Key& key, const Node& node) {
  const std::optional<ParameterId> id = stated_by(key, *reading.camera);
  if (!id) return schema::keep(reading, key, node);
  return reading.reader.parameter(node, reading.label(key), *id, reading.camera->model);
}

/// 0 of a pinhole, so that nobody has to know what a missing one means.
std::vector<Statement> write_coefficient(const Subject& subject, const Key& key) {
  const std::optional<ParameterId> id = stated_by(key, subject.the_camera());
  if (!id) return {};
  const double value = parameter(subject.the_camera().model, *id).value_or(0.0);
  return schema::states(fields::real(key.text(), value), {.kind = FactKind::kParameter, .parameter = id->name()});
}

constexpr Key coefficient(std::string_view name, ParameterId id) {
  return {name, FactKind::kParameter, read_coefficient, write_coefficient, {.parameter = id}};
}

/// The numbers of the file are those of the images as they come, whatever the program shrinks them by.
bool read_scale(Reading& reading, const Key& key, const Node& node) {
  const std::optional<double> scale = reading.reader.positive(node, reading.label(key));
  if (scale && *scale != 1.0) reading.rig.extra_fields.push_back({reading.owner, key.text(), node.value});
  return scale.has_value();
}

std::vector<Statement> write_scale(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr || id_of(subject.the_camera()) == "fov") return {};
  return schema::states(fields::real(key.text(), 1.0));
}

/// A camera without an angle has no ATAN.
bool check_angle(Reading& reading, const Key& key, const Node& node) {
  if (!schema::read_image_sides(reading, key, node)) return false;
  if (id_of(*reading.camera) != "fov") return true;
  return reading.reader.require(*reading.mapping, "cam_d0", reading.owner) != nullptr;
}

constexpr Key height(std::string_view name, std::string_view width) {
  Key key = schema::image_height(name, width, false);
  key.read = check_angle;
  return key;
}

constexpr std::array kKeys = {
    required(Key{kModelKey, FactKind::kModel, read_lens, write_lens}),
    required(schema::image_width("cam_width", false)),
    required(height("cam_height", "cam_width")),
    Key{"scale", FactKind::kOther, read_scale, write_scale},
    required(length("cam_fx", "fx")),
    required(length("cam_fy", "fy")),
    required(length("cam_cx", "cx")),
    required(length("cam_cy", "cy")),
    coefficient("cam_d0", "k1"),
    coefficient("cam_d1", "k2"),
    coefficient("cam_d2", "p1"),
    coefficient("cam_d3", "p2"),
    coefficient("k1", "k1"),
    coefficient("k2", "k2"),
    coefficient("k3", "k3"),
    coefficient("k4", "k4"),
};

/// rosparam reads it with PyYAML.
constexpr schema::Schema kTable = {.what = "a camera of FAST-LIVO",
                                   .dialect = text::Dialect::kPyYaml,
                                   .root = {.keys = kKeys, .unread = "", .warns_of_duplicates = true, .stops_at_error = true},
                                   .codes = {.wrong_syntax = Code::kTableWrongSyntax},
                                   .program = kProgram,
                                   .one_camera = true};

const Node* find(const Node& mapping, std::string_view key) { return text::find(mapping, key, kTable.dialect); }

/// The mapping with the camera's keys: the file, or in one of ROS 2 what stands below the camera's name; null if there is none.
const Node* keys_of(const Node& root) {
  if (find(root, kModelKey) != nullptr) return &root;
  for (const text::Entry& entry : root.entries) {
    if (find(entry.value, kModelKey) != nullptr) return &entry.value;
  }
  return nullptr;
}

/// What the file says besides those keys: of other cameras, and of time.
void keep_beside(const Node& root, Rig& rig) {
  const Node* keys = keys_of(root);
  if (keys == &root) return;
  for (const text::Entry& entry : root.entries) {
    if (&entry.value != keys) rig.extra_fields.push_back({"", entry.key.value, fields::value_text(entry.value)});
  }
}

/// The document with those keys alone.
text::Document keys_alone(const text::Document& document) {
  const Node* keys = keys_of(document.root());
  return keys != nullptr ? text::Document(document.source(), document.syntax(), *keys) : document;
}

/// The first coefficient of the lens that is missing; a file that was cut off says no less.
void warn_of_zeros(Reading& reading, const Node& keys) {
  const auto missing = std::ranges::find_if(kKeys, [&](const Key& key) {
    return key.read == read_coefficient && stated_by(key, *reading.camera) && find(keys, key.name) == nullptr;
  });
  if (missing == kKeys.end()) return;
  SourceRange where = reading.reader.document().range(keys);
  where.length = 1;
  reading.reader.diagnostics().add(Code::kOrbslamTakesZero, {missing->name, kProgram}, where);
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  if (documents.size() != 1 || !documents.front().root().is_mapping()) {
    diagnostics.add(Code::kTableWrongSyntax, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  const text::Document document = keys_alone(documents.front());
  fields::Reader reader(document, kTable.dialect, diagnostics);
  Rig rig;
  Camera camera;
  camera.name = "cam0";
  Reading reading{kTable, reader, options, rig, camera.name};
  reading.camera = &camera;
  if (!schema::read_mapping(reading, kTable.root, document.root())) return std::nullopt;
  warn_of_zeros(reading, document.root());
  reader.warn_of_misspelt();
  schema::keep_unread(reading, kTable.root, document.root(), camera.name);
  keep_beside(documents.front().root(), rig);
  rig.cameras.push_back(std::move(camera));
  return rig;
}

std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                             Diagnostics& diagnostics) {
  if (!writable_alone(kFormat, rig, Message{Code::kTableDemandsSize}, diagnostics)) return std::nullopt;
  Diagnostics ignored;
  const std::optional<Rig> there = base != nullptr ? read(std::span(base, 1), {}, ignored) : std::nullopt;
  const std::optional<Rig> old = options.rewrite ? std::nullopt : there;
  Written written;
  bool edits = false;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    const Camera& camera = rig.cameras[i];
    std::optional<text::Document> document;
    // Another lens has other keys.
    if (is_camera_of(old, rig, camera) && name_of(camera.model) == name_of(old->cameras.front().model)) {
      document = schema::edited(keys_alone(*base), {kTable, *old}, {kTable, rig, i}, written);
      edits = true;
    } else {
      const Subject subject{.schema = kTable, .rig = rig, .camera = i, .fresh = &written};
      document = schema::composed_yaml(subject, "", as_file_name(camera.name) + ".yaml", diagnostics);
    }
    if (!document) return std::nullopt;
    written.files.push_back({*std::move(document), {camera.name}, {"fast-livo"}});
  }
  if (base != nullptr && !edits) add_rewritten(*base, written.files.front().document, Message{}, written.losses);
  add_extras_lost(rig, edits ? old->extra_fields : std::vector<ExtraField>(), edits ? std::nullopt : there,
                  Message{Code::kFilesHaveNoPlace, {kProgram}}, written.losses);
  list_camera_losses(rig, kProgram, written.losses);
  written.headline = {Code::kTableWrote, {kFormat.main_file, kProgram}};
  return written;
}

ProbeResult probe(const text::Document& document) {
  const Node* keys = keys_of(document.root());
  // SVO's cameras have the same keys, and longer names for their lenses.
  const Node* model = keys != nullptr ? find(*keys, kModelKey) : nullptr;
  if (model == nullptr || (model->value.starts_with("Pinhole") && model->value != "Pinhole")) return {};
  for (const std::string_view key : {"cam_width", "cam_fx", "cam_calib_file"}) {
    if (find(*keys, key) != nullptr) {
      return {evidence::kCamera,
              Message{Code::kFoundKeys, {std::vector<std::string>{std::string(kModelKey), std::string(key)}}}};
    }
  }
  return {};
}

constexpr std::array kNoK3 = {ParameterRange{"k3", 0.0, 0.0}};
constexpr std::string_view kReaders = "FAST-LIVO, FAST-LIVO2";
constexpr std::array kModels = {
    StoredModel{"radtan", "Pinhole", true, kReaders, kNoK3, Code::kFastLivoNoK3},
    StoredModel{"kb4", "EquidistantCamera", true, "FAST-LIVO2", {}},
    StoredModel{"fov", "ATAN", true, kReaders, {}},
    StoredModel{"pinhole", "Pinhole with zeros", true, kReaders, {}},
};
constexpr std::array<std::string_view, 1> kOfTheImages = {"scale"};
constexpr std::array kOwnFacts = {OwnFact{"the factor that images are shrunk by", kOfTheImages}};

}  // namespace

const Format kFormat = {
    .id = "fast-livo",
    .title = "FAST-LIVO camera",
    .syntaxes = "YAML",
    .extension = ".yaml",
    .program = kProgram,
    .main_file = "camera_pinhole.yaml",
    .many_cameras = false,
    .extrinsics = false,
    .facts_apart = true,
    .imu = false,
    .image_size = true,
    .own_facts = kOwnFacts,
    .of_the_images = kOfTheImages,
    .models = kModels,
    .table = &kTable,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::fast_livo
