// SPDX-License-Identifier: BSD-3-Clause
// Functions that read and write keys of a lens given by two names and two lists of numbers, of a pose given as 16 numbers, and
// of a program's own settings.
#include "keys.h"

#include <fca/normalised_id.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace fca::schema {

using text::Node;

namespace {

constexpr std::array<ParameterId, 4> kFocalAndCentre = {"fx", "fy", "cx", "cy"};
constexpr std::size_t kLongestQuote = 40;  ///< The largest number of characters of a file's text that a message quotes.

/// The node's text as messages quote it.
std::string quote(const Node& node) { return node.value.substr(0, kLongestQuote); }

/// The length of the list of coefficients in the file.
std::size_t length_of(const ListLens& lens) { return lens.coefficients.size() + lens.zeros; }

/// True if the lens has both names. Like the programs, ignores upper and lower case.
bool has_names(const ListLens& lens, const Node& camera_model, const Node& distortion_model) {
  return normalised_id(lens.camera_model) == normalised_id(camera_model.value) &&
         normalised_id(lens.distortion_model) == normalised_id(distortion_model.value);
}

/// The first entry of the key's lenses that can represent the camera; null if there is none. A model may have several entries
/// with lists of different lengths: a short list is for cameras whose other parameters are 0.
const ListLens* lens_of(const CameraModel& model, const Key& key) {
  const auto can_represent = [&model](const ListLens& lens) {
    if (lens.model != model_info(model).id) return false;
    return std::ranges::all_of(lens.absent, [&model](ParameterId id) { return parameter(model, id) == 0.0; });
  };
  const auto found = std::ranges::find_if(key.with.list_lenses, can_represent);
  return found == key.with.list_lenses.end() ? nullptr : &*found;
}

/// Reads the parameters `ids` of the camera from a list, which ends with `zeros` further numbers that are ignored. False, with
/// an error, if the list has another length or an invalid number.
bool read_list(Reading& reading, const Key& key, const Node& node, std::span<const ParameterId> ids, std::size_t zeros) {
  const std::string what = reading.label(key);
  const bool fits = node.is_sequence() && node.items.size() == ids.size() + zeros;
  if (!fits) return reading.reader.reals(node, ids.size() + zeros, what) && fits;
  bool good = true;
  for (std::size_t i = 0; i < ids.size(); ++i)
    good = reading.reader.parameter(node.items[i], what, ids[i], reading.camera->model) && good;
  return good;
}

/// A list of the parameters `ids` of the camera, followed by `zeros` zeros.
std::vector<Statement> write_list(const Subject& subject, const Key& key, std::span<const ParameterId> ids, std::size_t zeros) {
  std::vector<double> values;
  Statement statement;
  for (const ParameterId id : ids) {
    values.push_back(parameter(subject.the_camera().model, id).value());
    statement.facts.push_back({.kind = FactKind::kParameter, .parameter = id.name()});
  }
  values.resize(ids.size() + zeros, 0.0);
  statement.field = fields::list(key.text(), values);
  return {std::move(statement)};
}

/// A list of the 16 numbers of T, row-major. `edge`: the pose of the rig that they belong to, or null.
std::vector<Statement> pose_statement(const Key& key, const Transform& T, const PoseEdge* edge) {
  Statement statement = {fields::list(key.text(), T.values), {}};
  for (int i = 0; i < 16; ++i)
    statement.facts.push_back({.kind = FactKind::kPose, .pose = edge, .row = i / 4, .column = i % 4});
  return {std::move(statement)};
}

}  // namespace

/// Reads the lens of a camera: the one that has both names. If several lenses have them, the number of coefficients decides.
bool read_list_lens(Reading& reading, const Key& key, const Node& node) {
  const Node* other = reading.reader.find(*reading.mapping, key.with.other);
  const Node* coefficients = reading.reader.find(*reading.mapping, key.with.list);
  if (other == nullptr) return false;  // the row of that key reports the error
  const auto has_both_names = [&](const ListLens& lens) { return has_names(lens, *other, node); };
  const std::span<const ListLens> lenses = key.with.list_lenses;
  if (std::ranges::none_of(lenses, has_both_names)) {
    const bool known = std::ranges::any_of(
        lenses, [other](const ListLens& lens) { return normalised_id(lens.camera_model) == normalised_id(other->value); });
    reading.reader.say(known ? node : *other, reading.schema.codes.unknown_lens,
                       {reading.camera->name, quote(*other), quote(node)});
    return false;
  }
  const std::size_t count = coefficients != nullptr ? coefficients->items.size() : 0;
  const auto lens =
      std::ranges::find_if(lenses, [&](const ListLens& each) { return has_both_names(each) && length_of(each) == count; });
  if (lens == lenses.end() && coefficients != nullptr && !std::ranges::find_if(lenses, has_both_names)->any_length) {
    std::set<std::size_t> lengths;
    for (const ListLens& each : lenses) {
      if (has_both_names(each)) lengths.insert(length_of(each));
    }
    std::vector<std::string> wanted;
    wanted.reserve(lengths.size());
    for (const std::size_t length : lengths) wanted.push_back(std::to_string(length));
    reading.reader.say(*coefficients, reading.schema.codes.coefficient_count,
                       {reading.owner + " " + std::string(key.with.list), count, wanted, quote(node)});
    return false;
  }
  const ListLens& taken = lens != lenses.end() ? *lens : *std::ranges::find_if(lenses, has_both_names);
  reading.camera->model = make_model(taken.model).value();
  reading.list_lens = &taken;
  if (taken.found != Code{}) reading.reader.say(node, taken.found, {reading.camera->name, quote(*other), quote(node)});
  return !reading.reader.diagnostics().has_errors();
}

/// Writes the second name of the lens (distortion_model).
std::vector<Statement> write_list_lens(const Subject& subject, const Key& key) {
  const ListLens* lens = lens_of(subject.the_camera().model, key);
  if (lens == nullptr) return {};
  return states(fields::scalar(key.text(), std::string(lens->distortion_model)), {FactKind::kModel});
}

/// Writes the first name of the lens.
std::vector<Statement> write_camera_model(const Subject& subject, const Key& key) {
  const ListLens* lens = lens_of(subject.the_camera().model, key);
  if (lens == nullptr) return {};
  return states(fields::scalar(key.text(), std::string(lens->camera_model)), {FactKind::kModel});
}

bool read_focal_and_centre(Reading& reading, const Key& key, const Node& node) {
  return read_list(reading, key, node, kFocalAndCentre, 0);
}

std::vector<Statement> write_focal_and_centre(const Subject& subject, const Key& key) {
  return write_list(subject, key, kFocalAndCentre, 0);
}

/// Reads the coefficients of the lens, which read_list_lens() must have found. The list of a lens without coefficients is not
/// read.
bool read_coefficients(Reading& reading, const Key& key, const Node& node) {
  if (reading.list_lens == nullptr) return false;
  const bool unread = reading.list_lens->coefficients.empty();
  return unread || read_list(reading, key, node, reading.list_lens->coefficients, reading.list_lens->zeros);
}

std::vector<Statement> write_coefficients(const Subject& subject, const Key& key) {
  const ListLens* lens = lens_of(subject.the_camera().model, key);
  if (lens == nullptr) return {};
  return write_list(subject, key, lens->coefficients, lens->zeros);
}

bool read_frame_rate(Reading& reading, const Key& key, const Node& node) {
  std::optional<double>& rate = reading.camera->frame_rate_hz;
  rate = reading.reader.positive(node, reading.label(key));
  return rate.has_value();
}

std::vector<Statement> write_frame_rate(const Subject& subject, const Key& key) {
  const std::optional<double>& rate = subject.the_camera().frame_rate_hz;
  if (!rate) return {};
  return states(fields::real(key.text(), *rate), {FactKind::kFrameRate});
}

bool read_side_of_four(Reading& reading, const Key& key, const Node& node) {
  const std::optional<int> side = reading.reader.integer(node, reading.label(key));
  if (side && *side != 4) reading.reader.say(node, reading.schema.codes.not_four, {reading.label(key), *side});
  return side == 4;
}

/// Writes nothing in an edit.
std::vector<Statement> write_side_of_four(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  return states(fields::integer(key.text(), 4));
}

/// True if T differs from the identity by at most gtsam's tolerance.
bool is_identity(const Transform& T) {
  constexpr double kTolerance = 1e-9;
  const Transform identity;
  return std::ranges::equal(T.values, identity.values, [](double a, double b) { return std::abs(a - b) <= kTolerance; });
}

/// Reads the pose of a camera. The pose of the camera that is itself the frame must be the identity.
bool read_matrix(Reading& reading, const Key& key, const Node& node) {
  const PoseLayout& layout = *key.with.pose;
  const std::optional<Transform> T = reading.reader.transform(node, reading.label(key));
  if (!T) return false;
  if (layout.kind != FrameKind::kImu && reading.camera->name == layout.frame) {
    if (!is_identity(*T)) reading.reader.say(node, reading.schema.codes.no_identity, {reading.label(key)});
    return is_identity(*T);
  }
  reading.rig.poses.push_back({std::string(layout.frame), reading.camera->name, *T});
  reading.rig.add_frame(layout.frame, layout.kind);
  return true;
}

/// Writes the pose of a camera. If it is not known, a fresh file gets an assumed pose (PoseFrame), and an edit changes nothing.
std::vector<Statement> write_matrix(const Subject& subject, const Key& key) {
  const Camera& camera = subject.the_camera();
  const PoseFrame frame(subject.rig, *key.with.pose);
  const bool fresh = subject.fresh != nullptr;
  const std::optional<Transform> T = fresh ? frame.pose(camera) : frame.own_pose(camera);
  if (fresh) frame.report_assumed_pose(key.with.other, *key.with.pose, camera, *subject.fresh);
  if (!fresh && !T) return {};
  return pose_statement(key, T.value_or(Transform{}), edge_of(subject.rig, key.with.pose->frame, camera.name));
}

bool read_identity(Reading& reading, const Key& key, const Node& node) {
  const std::optional<Transform> T = reading.reader.transform(node, reading.label(key));
  if (T && !is_identity(*T)) reading.reader.say(node, reading.schema.codes.no_identity, {reading.label(key)});
  return T && is_identity(*T);
}

/// Writes nothing in an edit.
std::vector<Statement> write_identity(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  return pose_statement(key, Transform{}, nullptr);
}

bool read_imu_matrix(Reading& reading, const Key& key, const Node& node) {
  const PoseLayout& layout = *key.with.pose;
  const std::optional<Transform> T = reading.reader.transform(node, reading.label(key));
  if (!T) return false;
  reading.rig.poses.push_back({std::string(layout.frame), reading.imu->name, *T});
  reading.rig.add_frame(layout.frame, layout.kind);
  return true;
}

/// Writes the pose of an IMU, as the rig contains it or as a product of its poses; nothing if it is not known.
std::vector<Statement> write_imu_matrix(const Subject& subject, const Key& key) {
  if (subject.imu >= subject.rig.imus.size()) return {};
  const std::string& imu = subject.rig.imus[subject.imu].name;
  const Transform* direct = subject.rig.stated(key.with.pose->frame, imu);
  const std::optional<Transform> T = direct != nullptr ? *direct : subject.rig.resolve(key.with.pose->frame, imu);
  if (!T) return {};
  return pose_statement(key, *T, edge_of(subject.rig, key.with.pose->frame, imu));
}

bool read_fixed(Reading& /*reading*/, const Key& /*key*/, const Node& /*node*/) { return true; }

/// Writes nothing in an edit.
std::vector<Statement> write_fixed(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  return states(fields::scalar(key.text(), std::string(key.with.token)));
}

const ExtraField* kept_tuning(const Rig& rig, const Key& key) {
  const ExtraField* kept = rig.find_extra_field("", std::string(key.with.other) + key.text());
  if (kept == nullptr) return nullptr;
  std::string_view value = kept->value;
  if (value.size() > 1 && value.starts_with('[') && value.ends_with(']')) value = value.substr(1, value.size() - 2);
  const bool is_numbers = value.find_first_not_of("0123456789+-.eE, ") == std::string_view::npos &&
                          value.find_first_of("0123456789") != std::string_view::npos;
  return is_numbers ? kept : nullptr;
}

/// Writes the value that the rig keeps as an extra field or, if it keeps none, the value in the program's own file.
std::vector<Statement> write_tuning(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  const ExtraField* kept = kept_tuning(subject.rig, key);
  const std::string token = kept != nullptr ? kept->value : std::string(key.with.token);
  if (kept == nullptr) subject.fresh->defaults.push_back({key.text(), token, false, false});
  return states(fields::scalar(key.text(), token));
}

bool read_tuning(Reading& reading, const Key& key, const Node& node) {
  reading.rig.extra_fields.push_back({"", std::string(key.with.other) + key.text(), fields::value_text(node)});
  return true;
}

}  // namespace fca::schema
