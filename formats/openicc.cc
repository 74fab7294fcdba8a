// SPDX-License-Identifier: BSD-3-Clause
// What OpenImuCameraCalibrator writes of a GoPro or a phone, and UMI reads; it is only read
// (urbste/OpenImuCameraCalibrator@5cf99f0: src/io/read_camera_calibration.cc, write_camera_calibration.cc,
// applications/continuous_time_imu_to_camera_calibration.cc; urbste/pyTheiaSfM's camera models;
// real-stanford/universal_manipulation_interface, umi/common/cv_util.py).
//
//   intrinsic_type                       a camera model of Theia
//   image_width, image_height, fps
//   intrinsics
//     focal_length, aspect_ratio         fx, and fy / fx; UMI's files of other cameras have fx and fy
//     principal_pt_x, principal_pt_y     the centre of the first pixel is (0, 0); or cx and cy
//     skew                               px: u = fx x + skew y + cx
//     radial_distortion_1, ...           of kTypes
//   q_i_c, t_i_c                         T_imu_cam: w x y z, and x y z in metres; here, or in a file of their own
//   time_offset_imu_to_cam_s             t_cam = t_imu + offset: the opposite sign of Kalibr's
//   trajectory                           of the calibration, thousands of samples: not read
#include "openicc.h"

#include "column.h"
#include "schema/keys.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::openicc {

using schema::FactKind;
using schema::Key;
using schema::Reading;
using schema::required;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

constexpr std::string_view kCamera = "cam0";
constexpr std::string_view kType = "intrinsic_type";
constexpr std::string_view kWidth = "image_width";
constexpr std::string_view kHeight = "image_height";
constexpr std::string_view kTimeOffset = "time_offset_imu_to_cam_s";

/// A key and the parameter that it specifies.
struct Coefficient {
  std::string_view key;
  ParameterId id;
};

constexpr std::array kRadialTangential = {Coefficient{"radial_distortion_1", "k1"}, Coefficient{"radial_distortion_2", "k2"},
                                          Coefficient{"radial_distortion_3", "k3"},
                                          Coefficient{"tangential_distortion_1", "p1"},
                                          Coefficient{"tangential_distortion_2", "p2"}};
constexpr std::array kFisheye = {Coefficient{"radial_distortion_1", "k1"}, Coefficient{"radial_distortion_2", "k2"},
                                 Coefficient{"radial_distortion_3", "k3"}, Coefficient{"radial_distortion_4", "k4"}};
constexpr std::array kDoubleSphere = {Coefficient{"xi", "xi"}, Coefficient{"alpha", "alpha"}};
constexpr std::array kExtendedUnified = {Coefficient{"alpha", "alpha"}, Coefficient{"beta", "beta"}};
/// In 1 / px^2.
constexpr std::array kDivision = {Coefficient{"div_undist_distortion", "k"}};
constexpr std::array kOpenCv = {Coefficient{"k1", "k1"}, Coefficient{"k2", "k2"}, Coefficient{"p1", "p1"},
                                Coefficient{"p2", "p2"}, Coefficient{"k3", "k3"}};

/// A camera model by the program's name.
struct Type {
  std::string_view name;
  std::string_view model;
  std::span<const Coefficient> coefficients = {};
};

constexpr std::array kTypes = {
    Type{"PINHOLE", "pinhole"},
    Type{"PINHOLE_RADIAL_TANGENTIAL", "radtan", kRadialTangential},
    Type{"FISHEYE", "kb4", kFisheye},
    Type{"DOUBLE_SPHERE", "ds", kDoubleSphere},
    Type{"EXTENDED_UNIFIED", "eucm", kExtendedUnified},
    Type{"DIVISION_UNDISTORTION", "division", kDivision},
    Type{"PERSPECTIVE", "radtan", kOpenCv},
};

const Type* find_type(std::string_view name) {
  const auto* const found = std::ranges::find(kTypes, name, &Type::name);
  return found == kTypes.end() ? nullptr : found;
}

bool read_type(Reading& reading, const Key& key, const Node& node) {
  const std::optional<std::string> name = reading.reader.string(node, key.name);
  const Type* type = name ? find_type(*name) : nullptr;
  if (type == nullptr) {
    if (name) reading.reader.say(node, Code::kTableUnknownWord, {key.name, *name, column(kTypes, &Type::name)});
    return false;
  }
  reading.lens = type->name;
  reading.camera->model = make_model(type->model).value();
  return true;
}

/// One side of the image, of which the other has to be there. Both are read with the height.
bool read_side(Reading& reading, const Key& key, const Node& node) {
  const Node* other = reading.reader.require(*reading.mapping, key.with.other, reading.schema.what);
  if (other == nullptr) return false;
  if (key.name != kHeight) return true;
  reading.camera->image_size = reading.reader.image_size(*other, node, "image ");
  return reading.camera->image_size.has_value();
}

/// The first of the keys that is there.
const Node* find_first(fields::Reader& reader, const Node& mapping, std::string_view key, std::string_view otherwise) {
  const Node* node = reader.find(mapping, key);
  return node != nullptr ? node : reader.find(mapping, otherwise);
}

std::string in_intrinsics(std::string_view key) { return "intrinsics " + std::string(key); }

bool read_focal_lengths(Reading& reading, const Node& node) {
  CameraModel& model = reading.camera->model;
  fields::Reader& reader = reading.reader;
  const Node* fx = find_first(reader, node, "focal_length", "fx");
  if (fx == nullptr) return reader.require(node, "focal_length", "intrinsics") != nullptr;
  if (!reader.parameter(*fx, in_intrinsics("focal length"), "fx", model)) return false;
  if (const Node* fy = reader.find(node, "fy")) return reader.parameter(*fy, in_intrinsics("fy"), "fy", model);
  const Node* aspect = reader.require(node, "aspect_ratio", "intrinsics");
  const std::optional<double> ratio =
      aspect != nullptr ? reader.positive(*aspect, in_intrinsics("aspect_ratio")) : std::nullopt;
  if (!ratio) return false;
  if (reading.lens == "DIVISION_UNDISTORTION" && *ratio != 1.0) {
    reader.say(*aspect, Code::kOpeniccDivisionAspect, {in_intrinsics("aspect_ratio"), *ratio});
    return false;
  }
  const double fy = *ratio * parameter(model, "fx").value();
  return reader.parameter(*aspect, in_intrinsics("aspect_ratio"), "fy", fy, model);
}

bool read_coefficients(Reading& reading, const Node& node) {
  CameraModel& model = reading.camera->model;
  for (const Coefficient& each : find_type(reading.lens)->coefficients) {
    const Node* number = reading.reader.require(node, each.key, "intrinsics");
    if (number == nullptr) return false;
    const std::optional<double> value = reading.reader.real(*number, in_intrinsics(each.key));
    if (!value) return false;
    // Ours counts the radius in focal lengths.
    const double fx = parameter(model, "fx").value();
    const double stated = reading.lens == "DIVISION_UNDISTORTION" ? *value * fx * fx : *value;
    if (!reading.reader.parameter(*number, in_intrinsics(each.key), each.id, stated, model)) return false;
  }
  return true;
}

bool read_skew(Reading& reading, const Node& node) {
  const Node* number = reading.reader.find(node, "skew");
  const std::optional<double> skew = number != nullptr ? reading.reader.real(*number, in_intrinsics("skew")) : 0.0;
  if (!skew || *skew == 0.0) return skew.has_value();
  CameraModel& model = reading.camera->model;
  const std::optional<CameraModel> skewed = with_skew(model, 0.0);
  if (!skewed) {
    reading.reader.say(*number, Code::kOpeniccSkew, {in_intrinsics("skew"), *skew, reading.lens});
    return false;
  }
  model = *skewed;
  return reading.reader.parameter(*number, in_intrinsics("skew"), "skew", *skew, model);
}

bool read_intrinsics(Reading& reading, const Key& key, const Node& node) {
  if (reading.lens.empty()) return false;
  if (!node.is_mapping()) {
    reading.reader.say(node, Code::kTableNoObject, {key.name});
    return false;
  }
  reading.reader.warn_of_duplicates(node);
  bool good = read_focal_lengths(reading, node);
  for (const auto& [name, otherwise, id] :
       {std::tuple{"principal_pt_x", "cx", ParameterId("cx")}, std::tuple{"principal_pt_y", "cy", ParameterId("cy")}}) {
    const Node* number = find_first(reading.reader, node, name, otherwise);
    if (number == nullptr) number = reading.reader.require(node, name, "intrinsics");
    good = number != nullptr && reading.reader.parameter(*number, in_intrinsics(name), id, reading.camera->model) && good;
  }
  return good && read_coefficients(reading, node) && read_skew(reading, node);
}

/// Where the parameters stand. fy stands in aspect_ratio or fy.
std::vector<Statement> write_intrinsics(const Subject& subject, const Key& /*key*/) {
  const CameraModel& model = subject.the_camera().model;
  std::vector<Statement> statements;
  const auto add = [&statements, &model](std::string_view key, ParameterId id) {
    const std::optional<double> value = parameter(model, id);
    if (value)
      statements.push_back({fields::real(std::string(key), *value), {{.kind = FactKind::kParameter, .parameter = id.name()}}});
  };
  add("focal_length", "fx");
  add("aspect_ratio", "fy");
  add("principal_pt_x", "cx");
  add("principal_pt_y", "cy");
  constexpr std::array<ParameterId, 4> kOwn = {"fx", "fy", "cx", "cy"};
  for (const ParameterId own : kOwn) add(own.name(), own);
  const auto* const type = std::ranges::find(kTypes, straight_id(model), &Type::model);
  for (const Coefficient& each : type != kTypes.end() ? type->coefficients : std::span<const Coefficient>())
    add(each.key, each.id);
  add("skew", "skew");
  return statements;
}

/// Numbers under keys of an object; nothing with an error.
std::optional<std::vector<double>> read_numbers(Reading& reading, std::string_view owner, const Node& node,
                                                std::span<const std::string_view> keys) {
  std::vector<double> numbers;
  for (const std::string_view key : keys) {
    const Node* number = reading.reader.require(node, key, owner);
    const std::optional<double> value =
        number != nullptr ? reading.reader.real(*number, std::string(owner) + " " + std::string(key)) : std::nullopt;
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
constexpr std::array<std::string_view, 4> kQuaternion = {"x", "y", "z", "w"};

bool read_pose(Reading& reading, const Key& key, const Node& rotation) {
  const Node* translation = reading.reader.require(*reading.mapping, key.with.other, reading.schema.what);
  if (translation == nullptr) return false;
  const auto q = read_numbers(reading, key.name, rotation, kQuaternion);
  const auto t = read_numbers(reading, key.with.other, *translation, kAxes);
  if (!q || !t) return false;
  const Quaternion stated = {(*q)[0], (*q)[1], (*q)[2], (*q)[3]};
  const double length = std::hypot(std::hypot(stated[0], stated[1]), std::hypot(stated[2], stated[3]));
  constexpr double kPrinted = 1e-2;  // far more than digits that were left out
  if (!(std::abs(length - 1.0) <= kPrinted)) {
    const double defect = std::abs(std::pow(length, 4) - 1.0);  // of the matrix that is made of such a quaternion
    reading.reader.say(rotation, Code::kRotationImpossible, {key.name, Message{Code::kNotOrthonormal, {defect}}});
    return false;
  }
  const Transform T = pose_of(normalised(stated), {(*t)[0], (*t)[1], (*t)[2]});
  const std::optional<Transform> checked = reading.reader.checked(T, {rotation, key.name}, {*translation, key.with.other});
  if (!checked) return false;
  reading.rig.poses.push_back({std::string(schema::kImu), std::string(kCamera), *checked});
  reading.rig.add_frame(schema::kImu, FrameKind::kImu);
  return true;
}

/// Kept for the camera where another file specifies that.
bool read_offset(Reading& reading, const Key& key, const Node& node) {
  const std::optional<double> offset = reading.reader.time_offset(node, key.name);
  if (!offset) return false;
  if (reading.camera != nullptr) {
    reading.camera->time_offset_s = 0.0 - *offset;
  } else {
    reading.rig.extra_fields.push_back({std::string(schema::kImu), key.text(), node.value});
  }
  return true;
}

constexpr Key kIntrinsics = {"intrinsics", FactKind::kParameter, read_intrinsics, write_intrinsics, {}, nullptr, true};
constexpr Key kRotation = {"q_i_c", FactKind::kPose, read_pose, nullptr, {.other = "t_i_c"}};
constexpr Key kOffset = {kTimeOffset, FactKind::kTimeOffset, read_offset};

constexpr std::array kLensKeys = {
    required(Key{kType, FactKind::kModel, read_type}),
    required(kIntrinsics),
    Key{kWidth, FactKind::kImageSize, read_side, schema::write_image_width, {.other = kHeight}},
    Key{kHeight, FactKind::kImageSize, read_side, schema::write_image_height, {.other = kWidth}},
    schema::frame_rate("fps"),
    kRotation,
    schema::unread("t_i_c"),
    kOffset,
    schema::unread("trajectory"),
};
constexpr std::array kPoseKeys = {required(kRotation), schema::unread("t_i_c"), kOffset, schema::unread("trajectory")};

constexpr schema::Schema schema_of(std::string_view what, std::span<const Key> keys, bool one_camera) {
  return {.what = what,
          .dialect = text::Dialect::kPyYaml,
          .root = {.keys = keys, .unread = "", .warns_of_duplicates = true, .stops_at_error = true},
          .codes = {.wrong_syntax = Code::kTableWrongSyntax, .no_object = Code::kTableNoObject},
          .program = "OpenImuCameraCalibrator",
          .one_camera = one_camera};
}
constexpr schema::Schema kLensTable = schema_of("a lens of OpenImuCameraCalibrator", kLensKeys, true);
constexpr schema::Schema kPoseTable = schema_of("a result of OpenImuCameraCalibrator", kPoseKeys, false);

bool has(const text::Document& document, std::string_view key) {
  return text::find(document.root(), key, kLensTable.dialect) != nullptr;
}

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  const bool is_pose = documents.size() == 1 && has(documents.front(), kRotation.name) && !has(documents.front(), kType) &&
                       !has(documents.front(), kIntrinsics.name);
  std::optional<Rig> rig = schema::read(is_pose ? kPoseTable : kLensTable, documents, options, diagnostics);
  for (Camera& camera : rig ? std::span(rig->cameras) : std::span<Camera>()) {
    if (!camera.image_size) camera.image_size = options.image_size;
  }
  return rig;
}

/// The time offset of a file without a lens is the camera's.
void complete(Rig& rig) {
  const ExtraField* field = rig.find_extra_field(schema::kImu, kTimeOffset);
  if (field == nullptr || rig.cameras.size() != 1 || rig.cameras.front().time_offset_s) return;
  rig.cameras.front().time_offset_s = 0.0 - text::parse_real(field->value).value_or(0.0);
  std::erase_if(rig.extra_fields, [](const ExtraField& extra) { return extra.key == kTimeOffset; });
}

ProbeResult probe(const text::Document& document) {
  const auto found = [](std::string_view a, std::string_view b) {
    return Message{Code::kFoundKeys, {std::vector<std::string>{std::string(a), std::string(b)}}};
  };
  if (has(document, kType) && has(document, kIntrinsics.name)) return {evidence::kCamera, found(kType, kIntrinsics.name)};
  if (has(document, kRotation.name) && has(document, "t_i_c")) return {evidence::kPart, found(kRotation.name, "t_i_c")};
  if (has(document, kType)) return {evidence::kHint, Message{Code::kFoundKey, {kType}}};
  return {};
}

constexpr std::string_view kProgram = "OpenImuCameraCalibrator";
constexpr std::array kModels = {
    StoredModel{"kb4", "FISHEYE", true, "OpenImuCameraCalibrator, UMI", {}},
    StoredModel{"radtan", "PINHOLE_RADIAL_TANGENTIAL", true, kProgram, {}},
    StoredModel{"ds", "DOUBLE_SPHERE", true, kProgram, {}},
    StoredModel{"eucm", "EXTENDED_UNIFIED", true, kProgram, {}},
    StoredModel{"division", "DIVISION_UNDISTORTION", true, kProgram, {}},
    StoredModel{"pinhole", "PINHOLE", true, kProgram, {}},
    StoredModel{"kb4-skew", "FISHEYE with skew", true, kProgram, {}},
};
constexpr std::array kOwnFacts = {OwnFact{"errors of the calibration, delay of a row"}};
constexpr std::array<std::string_view, 2> kOfTheImages = {"calib_line_delay_us", "init_line_delay_us"};

}  // namespace

const Format kFormat = {
    .id = "openicc",
    .title = "OpenImuCameraCalibrator JSON",
    .group = FormatGroup::kCalibration,
    .syntaxes = "JSON",
    .extension = ".json",
    .program = kProgram,
    .main_file = "cam_calib.json",
    .many_cameras = false,
    .extrinsics = true,
    .imu = false,
    .imu_pose = true,
    .image_size = true,
    .time_offset = true,
    .frame_rate = true,
    .own_facts = kOwnFacts,
    .of_the_images = kOfTheImages,
    .models = kModels,
    .table = &kLensTable,
    .probe = probe,
    .complete = complete,
    .read = read,
};

}  // namespace fca::openicc
