// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "own_lens.h"

#include "../rotation_vector.h"
#include "../schema/keys.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>

namespace fca::mrcal {

using schema::FactKind;
using schema::Key;
using schema::Reading;
using schema::required;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

constexpr std::array<ParameterId, 4> kFocalAndCentre = {"fx", "fy", "cx", "cy"};
constexpr std::size_t kLongestWord = 100;  ///< Of the file, in a message.

/// Lenses of mrcal that are no lens of OpenCV and are not read: the beginnings of their names.
constexpr std::array<std::string_view, 2> kUnreadLenses = {"LENSMODEL_CAHVORE", "LENSMODEL_SPLINED_STEREOGRAPHIC"};

bool has_room_for(const LensModel& lens, const CameraModel& model) {
  if (model_info(model).id != lens.model) return false;
  return std::all_of(kOpenCvCoefficients.begin() + static_cast<std::ptrdiff_t>(lens.coefficients), kOpenCvCoefficients.end(),
                     [&model](const ParameterId& id) { return parameter(model, id).value_or(0.0) == 0.0; });
}

/// Of several keys the first that is there counts.
bool read_lens(Reading& reading, const Key& key, const Node& node) {
  if (!reading.lens.empty()) return true;
  const LensModel* lens = node.is_scalar() ? find_lens(node.value) : nullptr;
  if (lens != nullptr) {
    reading.camera->model = make_model(lens->model).value();
    reading.lens = lens->name;
    return true;
  }
  const std::string name = todays_name(node.value);
  if (node.is_scalar() && numbers_of_own_lens(name)) {
    reading.lens = node.value;
    return true;
  }
  const std::string shown = node.value.substr(0, kLongestWord);
  if (std::ranges::any_of(kUnreadLenses, [&name](std::string_view begin) { return name.starts_with(begin); })) {
    reading.reader.say(node, Code::kMrcalUnreadLens, {key.name, shown});
    return false;
  }
  std::vector<std::string> names;
  names.reserve(kLenses.size());
  for (const LensModel& each : kLenses) names.emplace_back(each.name);
  reading.reader.say(node, Code::kTableUnknownWord, {key.name, shown, names});
  return false;
}

std::vector<Statement> write_lens(const Subject& subject, const Key& key) {
  return schema::states(fields::quoted(key.text(), lens_for(subject.the_camera().model, nullptr).name), {FactKind::kModel});
}

constexpr Key lens(std::string_view name) { return {name, FactKind::kModel, read_lens, write_lens}; }
constexpr Key old_lens(std::string_view name) { return {name, FactKind::kModel, read_lens}; }

bool read_intrinsics(Reading& reading, const Key& key, const Node& node) {
  if (reading.lens.empty()) {
    [[maybe_unused]] const Node* none =
        reading.reader.require(*reading.mapping, kLensKeys.front(), reading.schema.what);  // says that there is none
    return false;
  }
  if (const std::optional<std::size_t> count = numbers_of_own_lens(todays_name(reading.lens)))
    return reading.reader.reals(node, *count, key.name).has_value();
  const LensModel& lens = *find_lens(reading.lens);
  const std::vector<ParameterId> ids = parameters_of(lens);
  if (node.is_sequence() && node.items.size() != ids.size()) {
    const std::vector<std::string> wanted = {std::to_string(ids.size())};
    reading.reader.say(node, Code::kTableCoefficientCount, {key.name, node.items.size(), wanted, lens.name});
    return false;
  }
  if (!node.is_sequence()) return reading.reader.reals(node, ids.size(), key.name).has_value();
  bool good = true;
  for (std::size_t i = 0; i < ids.size(); ++i)
    good = reading.reader.parameter(node.items[i], key.name, ids[i], reading.camera->model) && good;
  return good;
}

std::vector<Statement> write_intrinsics(const Subject& subject, const Key& /*key*/) {
  const CameraModel& model = subject.the_camera().model;
  const LensModel& lens = lens_for(model, nullptr);
  Statement statement = {intrinsics_field(model, lens), {}};
  for (const ParameterId& id : parameters_of(lens))
    statement.facts.push_back({.kind = FactKind::kParameter, .parameter = id.name()});
  return {std::move(statement)};
}

/// mrcal since 2.5 demands of two keys that they differ by less.
constexpr double kSame = 1e-9;

bool read_pose(Reading& reading, const Key& key, const Node& node) {
  const std::optional<std::vector<double>> numbers = reading.reader.reals(node, 6, key.name);
  if (!numbers) return false;
  constexpr double kLargestAngle = 100.0;  // rad; of far more than a turn the numbers are no radians
  if (const double angle = std::hypot((*numbers)[0], (*numbers)[1], (*numbers)[2]); angle > kLargestAngle) {
    reading.reader.say(node, Code::kOpencvAngleTooLarge, {key.name, angle});
    return false;
  }
  std::array<double, 6> rt{};
  std::ranges::copy(*numbers, rt.begin());
  const std::optional<Transform> T = reading.reader.checked(pose_of(rt), node, key.name);
  if (!T) return false;
  const Node* first = text::find(*reading.mapping, kPoseKeys.front(), kDialect);
  if (key.name == kPoseKeys.front() || first == nullptr) {
    reading.rig.poses.push_back({reading.camera->name, std::string(kReference), *T});
    reading.rig.add_frame(kReference, FrameKind::kOther);
    return true;
  }
  // The first has been read.
  for (std::size_t i = 0; i < rt.size(); ++i) {
    if (std::abs(rt.at(i) - text::parse_real(first->items[i].value).value_or(0.0)) < kSame) continue;
    reading.reader.say(node.items[i], Code::kMrcalPosesDiffer, {kPoseKeys[0], kPoseKeys[1]});
    return false;
  }
  return true;
}

std::vector<Statement> write_pose(const Subject& subject, const Key& key) {
  const Camera& camera = subject.the_camera();
  const std::optional<Transform> T = pose_in(reference_of(subject.rig), subject.rig, camera);
  if (!T) return {};
  Statement statement = {fields::list(key.text(), rt_of(*T)), {}};
  const PoseEdge* edge = schema::edge_of(subject.rig, camera.name, kReference);
  for (int i = 0; i < 3; ++i) statement.facts.push_back({.kind = FactKind::kPose, .pose = edge, .row = -1});
  for (int row = 0; row < 3; ++row) statement.facts.push_back({.kind = FactKind::kPose, .pose = edge, .row = row, .column = 3});
  return {std::move(statement)};
}

constexpr Key pose(std::string_view name) { return {name, FactKind::kPose, read_pose, write_pose}; }

/// Some hundred thousand characters, of which their number is kept.
bool keep_inputs(Reading& reading, const Key& key, const Node& node) {
  reading.rig.extra_fields.push_back({reading.camera->name, key.text(), std::to_string(node.value.size()) + " characters"});
  return true;
}

constexpr std::array kKeys = {
    lens(kLensKeys[0]),
    old_lens(kLensKeys[1]),
    old_lens(kLensKeys[2]),
    required(Key{kIntrinsics, FactKind::kParameter, read_intrinsics, write_intrinsics}),
    pose(kPoseKeys[0]),
    pose(kPoseKeys[1]),
    required(schema::image_size(kImageSize)),
    Key{kInputs, FactKind::kOther, keep_inputs},
};

}  // namespace

constexpr schema::PoseLayout kPose = {.frame = kReference, .kind = FrameKind::kOther, .translation = {}, .rotation = {}};

constexpr schema::Schema kSchema = {.what = "a camera model",
                                    .dialect = kDialect,
                                    .root = {.keys = kKeys, .unread = "", .warns_of_duplicates = true, .stops_at_error = true},
                                    .codes = {.wrong_syntax = Code::kTableWrongSyntax, .no_size = Code::kTableNoSize},
                                    .program = "mrcal"};

std::string todays_name(std::string_view name) {
  constexpr std::string_view kOld = "DISTORTION";
  std::string result(name);
  if (result.starts_with(kOld)) result.replace(0, kOld.size(), "LENSMODEL");
  return result;
}

const LensModel* find_lens(std::string_view name) {
  const auto* const found = std::ranges::find(kLenses, todays_name(name), &LensModel::name);
  return found == kLenses.end() ? nullptr : &*found;
}

const LensModel& lens_for(const CameraModel& model, const LensModel* there) {
  if (there != nullptr && has_room_for(*there, model)) return *there;
  const auto* const found =
      std::ranges::find_if(kLenses, [&model](const LensModel& lens) { return has_room_for(lens, model); });
  return found != kLenses.end() ? *found : kLenses.back();
}

std::vector<ParameterId> parameters_of(const LensModel& lens) {
  std::vector<ParameterId> ids(kFocalAndCentre.begin(), kFocalAndCentre.end());
  for (std::size_t i = 0; i < lens.coefficients; ++i) ids.push_back(kOpenCvCoefficients.at(i));
  return ids;
}

fields::Field intrinsics_field(const CameraModel& model, const LensModel& lens) {
  std::vector<double> values;
  for (const ParameterId& id : parameters_of(lens)) values.push_back(parameter(model, id).value_or(0.0));
  return fields::list(std::string(kIntrinsics), values);
}

Transform pose_of(const std::array<double, 6>& rt) {
  Transform T;
  set_rotation({rt[0], rt[1], rt[2]}, T);
  for (int row = 0; row < 3; ++row) T(row, 3) = rt.at(static_cast<std::size_t>(3 + row));
  return T;
}

std::array<double, 6> rt_of(const Transform& T_camera_reference) {
  const RotationVector r = rotation_vector_of(T_camera_reference);
  return {r[0], r[1], r[2], T_camera_reference(0, 3), T_camera_reference(1, 3), T_camera_reference(2, 3)};
}

std::string reference_of(const Rig& rig) { return schema::PoseFrame(rig, kPose).name(); }

std::optional<Transform> pose_in(const std::string& frame, const Rig& rig, const Camera& camera) {
  if (camera.name == frame) return Transform{};
  const Transform* stated = rig.stated(camera.name, frame);
  return stated != nullptr ? *stated : rig.resolve(camera.name, frame);
}

}  // namespace fca::mrcal
