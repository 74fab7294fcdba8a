// SPDX-License-Identifier: BSD-3-Clause
// WoodScape: one JSON per camera (valeoai/WoodScape, scripts/calibration/projection.py and calibration.txt).
//
//   intrinsic   aspect_ratio, cx_offset, cy_offset, height, k1 .. k4 [px / rad^i], model "radial_poly", poly_order 4, width
//               principal point = size / 2 - 0.5 + offset; aspect_ratio multiplies v only
//   extrinsic   quaternion x y z w and translation [m]: p_vehicle = R p_camera + t; vehicle: ISO 8855, x forward, y left, z up
//   name        "FV", "RV", "MVL", "MVR"
//
// omnidet, the dataset's other program, takes the values of intrinsic by their place: the order of the keys is part of the
// format.
#include "layout.h"
#include "woodscape.h"

#include "../schema/keys.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fca::woodscape {

using schema::FactKind;
using schema::Key;
using schema::Reading;
using schema::required;
using schema::Statement;
using schema::Subject;
using schema::wanted;
using text::Node;

namespace {

// Rows that only WoodScape has.

/// projection.py looks at neither name nor order, but forks use the name for other models, and a fifth coefficient would be
/// left out.
bool read_model(Reading& reading, const Key& /*key*/, const Node& node) {
  if (node.value == kModel) return true;
  reading.reader.say(node, Code::kWoodscapeJsonOtherModel, {node.value});
  return false;
}

std::vector<Statement> write_model(const Subject& /*subject*/, const Key& key) {
  return schema::states(fields::quoted(key.text(), kModel));
}

bool read_order(Reading& reading, const Key& /*key*/, const Node& node) {
  if (text::parse_real(node.value) == 4.0) return true;
  reading.reader.say(node, Code::kWoodscapeJsonOtherOrder, {node.value});
  return false;
}

std::vector<Statement> write_order(const Subject& /*subject*/, const Key& key) {
  return schema::states(fields::integer(key.text(), 4));
}

/// k1 is the radius per radian near the axis, in pixels: 200 to 600 for the dataset's cameras.
bool read_k1(Reading& reading, const Key& key, const Node& node) {
  if (!schema::read_parameter(reading, key, node)) return false;
  if (reading.reader.diagnostics().has_errors()) return true;
  constexpr double kFewestPixels = 20.0;  // 10.3 are a dataset camera's pixels per degree
  const double value = parameter(reading.camera->model, "k1").value();
  if (value >= kFewestPixels) return true;
  if (value > 1.0) {
    reading.reader.say(node, Code::kWoodscapeJsonPerDegree, {node.value, value * 180.0 / std::numbers::pi});
  } else {
    reading.reader.say(node, Code::kWoodscapeJsonKannalaBrandt, {node.value});
  }
  return false;
}

constexpr Key k1(std::string_view name) {
  Key key = schema::parameter(name, "k1");
  key.read = read_k1;
  return key;
}

int side_of(const Camera& camera, const Key& key) {
  const ImageSize size = camera.image_size.value_or(ImageSize{});
  return key.with.parameter == ParameterId("cx") ? size.width : size.height;
}

/// The principal point, from the middle of the image.
bool read_offset(Reading& reading, const Key& key, const Node& node) {
  Camera& camera = *reading.camera;
  const std::optional<double> offset = reading.reader.real(node, key.name);
  return offset &&
         reading.reader.parameter(node, key.name, *key.with.parameter, centre_of(*offset, side_of(camera, key)), camera.model);
}

std::vector<Statement> write_offset(const Subject& subject, const Key& key) {
  const Camera& camera = subject.the_camera();
  const double centre = parameter(camera.model, *key.with.parameter).value();
  std::vector<Statement> statements = schema::write_parameter(subject, key);
  statements.front().field = fields::real(key.text(), offset_of(centre, side_of(camera, key)));
  return statements;
}

constexpr Key offset(std::string_view name, ParameterId id) {
  Key key = schema::parameter(name, id);
  key.read = read_offset;
  key.write = write_offset;
  return key;
}

/// A coefficient of a longer polynomial.
constexpr Key ignored(std::string_view name) {
  const auto warn = [](Reading& reading, const Key& key, const Node& node) {
    if (text::parse_real(node.value) != 0.0) reading.reader.say(node, Code::kWoodscapeJsonReadByNobody, {key.name});
    return true;
  };
  return {name, FactKind::kOther, warn, nullptr, {.only_warns = true}};
}

constexpr std::array<std::string_view, 1> kTranslation = {"translation"};
constexpr std::array<std::string_view, 1> kRotation = {"quaternion"};

}  // namespace

constexpr schema::PoseLayout kPoseInVehicle = {.frame = "vehicle",
                                               .kind = FrameKind::kVehicle,
                                               .translation = kTranslation,
                                               .rotation = kRotation,
                                               .rotation_first = true,
                                               .in_frame = Code::kOpenvinsChainPoseInFrame,
                                               .identity = Code::kIdentity,
                                               .made_up = Code::kWoodscapeJsonPoseMadeUp};

namespace {

/// scipy normalises any length whose square neither over- nor underflows; a far other one is no quaternion of a rotation.
bool is_rotation(Reading& reading, const Node& node, const std::vector<double>& q) {
  const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(norm > 0.0)) {
    reading.reader.say(node, Code::kWoodscapeJsonQuaternionZero);
    return false;
  }
  constexpr double kLongest = 1e3;
  if (norm > kLongest || norm < 1.0 / kLongest) {
    const auto beyond = std::ranges::find_if(q, [](double value) { return std::abs(value) > kLongest; });
    const Node& place = beyond == q.end() ? node : node.items[static_cast<std::size_t>(beyond - q.begin())];
    reading.reader.say(place, Code::kWoodscapeJsonQuaternionLength, {norm});
    return false;
  }
  constexpr double kPrinted = 1e-3;
  if (std::abs(norm - 1.0) > kPrinted) reading.reader.say(node, Code::kWoodscapeJsonQuaternionNormalised, {norm});
  return true;
}

/// False with an error if what stands there is no pose; a missing one is a warning.
bool read_extrinsic(Reading& reading, const Key& key, const Node& node) {
  Reading inside = reading;
  inside.owner = key.name;
  // The published files cannot all be read by one rule: two have the height after x and y to the right of it, two before.
  const text::Entry* carla = text::find_entry(node, kCarlaTranslation, kDialect);
  if (carla != nullptr && reading.reader.find(node, kTranslation.front()) == nullptr) {
    reading.reader.say(carla->key, Code::kWoodscapeJsonCarla, {kTranslation.front()});
    return true;
  }
  const Node* quaternion = schema::find_value(inside, wanted({.name = kRotation.front()}), node);
  const Node* translation = schema::find_value(inside, wanted({.name = kTranslation.front()}), node);
  if (quaternion == nullptr || translation == nullptr) return true;
  const std::optional<std::vector<double>> q = reading.reader.reals(*quaternion, 4, "quaternion (x y z w)");
  const std::optional<std::vector<double>> t = reading.reader.reals(*translation, 3, "translation");
  if (!q || !t || !is_rotation(reading, *quaternion, *q)) return false;
  const Transform T = pose_of(normalised({(*q)[0], (*q)[1], (*q)[2], (*q)[3]}), {(*t)[0], (*t)[1], (*t)[2]});
  return add_pose(inside, kPoseInVehicle, T, {*quaternion, "quaternion"}, {*translation, "translation"});
}

constexpr Key extrinsic(std::string_view name) {
  Key key = schema::pose(name, kPoseInVehicle);
  key.read = read_extrinsic;
  return key;
}

constexpr std::array kIntrinsicKeys = {
    Key{"model", FactKind::kOther, read_model, write_model},
    Key{"poly_order", FactKind::kOther, read_order, write_order},
    required(k1("k1")),
    required(schema::parameter("k2", "k2")),
    required(schema::parameter("k3", "k3")),
    required(schema::parameter("k4", "k4")),
    required(schema::parameter("aspect_ratio", "aspect_ratio")),
    required(schema::image_width("width", true)),
    required(schema::image_height("height", "width", true)),
    required(offset("cx_offset", "cx")),
    required(offset("cy_offset", "cy")),
    ignored("k5"),
    ignored("k6"),
};
constexpr std::array<std::string_view, 11> kIntrinsicOrder = {
    "aspect_ratio", "cx_offset", "cy_offset", "height", "k1", "k2", "k3", "k4", "model", "poly_order", "width"};
constexpr schema::Mapping kIntrinsic = {.keys = kIntrinsicKeys, .written = kIntrinsicOrder, .unread = "intrinsic."};

constexpr std::array kRootKeys = {schema::camera_name("name"), required(schema::object("intrinsic", kIntrinsic)),
                                  wanted(extrinsic("extrinsic"))};
constexpr std::array<std::string_view, 3> kRootOrder = {"extrinsic", "intrinsic", "name"};

}  // namespace

constexpr schema::Schema kSchema = {.what = "a WoodScape calibration",
                                    .dialect = kDialect,
                                    .root = {.keys = kRootKeys, .written = kRootOrder, .unread = "", .stops_at_error = true},
                                    .codes = {.wrong_syntax = Code::kWoodscapeJsonOneObject,
                                              .missing = Code::kWoodscapeJsonMissing,
                                              .missing_below = Code::kWoodscapeJsonMissingKey,
                                              .wrong = Code::kWoodscapeJsonNoObject,
                                              .unless_wanted = Code::kWoodscapeJsonPoseNotKnown},
                                    .one_camera = true,
                                    .model = "woodscape",
                                    .numbers_in_lines = true};

const Key& pose_key() { return kRootKeys.back(); }

}  // namespace fca::woodscape
