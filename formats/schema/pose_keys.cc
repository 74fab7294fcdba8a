// SPDX-License-Identifier: BSD-3-Clause
// Functions that read, write and edit a key that holds a pose as a translation and a quaternion.
#include "keys.h"

#include <fca/formats/text/numbers.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace fca::schema {

using text::Node;

namespace {

/// The smallest difference between a matrix and the rotation of its quaternion that is reported.
constexpr double kSmallestReported = 1e-9;
constexpr double kSameRotation = 1e-12;  ///< Two rotations whose elements differ by at most this are the same.
/// The largest deviation from length 1 of a quaternion that was printed with few digits.
constexpr double kPrinted = 1e-3;

/// The statements of a pose's translation or rotation: one list if `keys` has one key, otherwise one statement per number.
std::vector<Statement> statements_of(std::span<const std::string_view> keys, std::span<const double> values,
                                     std::span<const Fact> facts) {
  if (keys.size() == 1) return {{fields::list(std::string(keys.front()), values), {facts.begin(), facts.end()}}};
  std::vector<Statement> statements;
  for (std::size_t i = 0; i < values.size(); ++i)
    statements.push_back({fields::real(std::string(keys[i]), values[i]), {facts[i]}});
  return statements;
}

/// The statements of the translation of T. `edge`: the pose of the rig that the numbers belong to, or null.
std::vector<Statement> translation_of_pose(const PoseLayout& layout, const Transform& T, const PoseEdge* edge) {
  const Fact x = {.kind = FactKind::kPose, .pose = edge, .row = 0, .column = 3};
  std::array facts = {x, x, x};
  for (int row = 1; row < 3; ++row) facts.at(static_cast<std::size_t>(row)).row = row;
  return statements_of(layout.translation, translation_of(T), facts);
}

/// The statements of a quaternion. Each of its numbers depends on all elements of the rotation matrix (row -1 of a Fact).
std::vector<Statement> rotation_of_pose(const PoseLayout& layout, const Quaternion& q, const PoseEdge* edge) {
  const Fact any_element = {.kind = FactKind::kPose, .pose = edge, .row = -1};
  return statements_of(layout.rotation, q, std::array{any_element, any_element, any_element, any_element});
}

/// The quaternion that the file gets. If the layout reports changed poses (`restated`), that of the rotation nearest to T.
Quaternion quaternion_for(const PoseLayout& layout, const Transform& T) {
  return quaternion_of(layout.restated != Code{} ? nearest_rotation(T).value_or(T) : T);
}

/// The nodes of the numbers of a translation or rotation; null for a number whose key is missing.
std::vector<const Node*> numbers_of(const Node& pose, std::span<const std::string_view> keys, text::Dialect dialect) {
  std::vector<const Node*> numbers;
  for (const std::string_view key : keys) {
    const Node* node = text::find(pose, key, dialect);
    if (keys.size() > 1) numbers.push_back(node);
    if (keys.size() > 1 || node == nullptr) continue;
    for (const Node& item : node->items) numbers.push_back(&item);
  }
  return numbers;
}

/// The quaternion in the file, with 0 for each number that is missing or cannot be read.
Quaternion quaternion_in_file(const Node& pose, const PoseLayout& layout, text::Dialect dialect) {
  Quaternion q{};
  const std::vector<const Node*> numbers = numbers_of(pose, layout.rotation, dialect);
  for (std::size_t i = 0; i < std::min(q.size(), numbers.size()); ++i)
    q.at(i) = numbers[i] != nullptr ? text::parse_real(numbers[i]->value).value_or(0.0) : 0.0;
  return q;
}

/// Reports the change if the matrix T, which is written as a quaternion, is not exactly a rotation. Such a matrix was printed
/// with few digits, or is a product of such matrices.
void report_rounded_pose(const PoseFrame& frame, const Key& key, const Camera& camera, const Transform& T, Written& written) {
  const PoseLayout& layout = *key.with.pose;
  const Transform written_pose = pose_of(quaternion_for(layout, T), translation_of(T));
  const double largest_change = largest_difference(written_pose, T).distance;
  if (layout.restated == Code{} || !frame.known() || largest_change <= kSmallestReported) return;
  written.restated.push_back({frame.name(), camera.name, written_pose});
  written.losses.push_back(lost(layout.restated, camera.name, key.text(), {frame.name(), largest_change}));
}

/// Reads the three numbers of the translation and the four of the quaternion, each under a key of its own. nullopt, with an
/// error, if a key is missing or its value is no number. A layout with lists needs another reader.
std::optional<std::vector<double>> read_numbers(Reading& reading, const Key& key, const Node& node) {
  const std::string what = reading.label(key);
  std::vector<double> numbers;
  for (const auto& keys : {key.with.pose->translation, key.with.pose->rotation}) {
    for (const std::string_view name : keys) {
      const Node* number = reading.reader.require(node, name, what);
      const std::optional<double> value =
          number != nullptr ? reading.reader.real(*number, what + " " + std::string(name)) : std::nullopt;
      if (!value) return std::nullopt;
      numbers.push_back(*value);
    }
  }
  return numbers;
}

/// The quaternion scaled to length 1. Adds a warning if its length differs from 1 by more than kPrinted. If the length is
/// outside the layout's limits, adds an error instead and returns nullopt.
std::optional<Quaternion> unit_quaternion(Reading& reading, const Key& key, const Quaternion& q, const Node& place) {
  const PoseLayout& layout = *key.with.pose;
  const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (std::abs(norm - 1.0) <= kPrinted) return normalised(q);
  const bool near = norm >= layout.shortest && norm <= layout.longest;
  reading.reader.say(near ? Severity::kWarning : Severity::kError, place, norm > 0.0 ? layout.wrong_length : layout.zero_length,
                     {reading.label(key), norm});
  return near ? std::optional(normalised(q)) : std::nullopt;
}

/// The node of the first coordinate that exceeds the largest distance allowed in a rig; the first node if none does.
const Node& coordinate_beyond_limit(const std::vector<const Node*>& translation) {
  const auto beyond = std::ranges::find_if(
      translation, [](const Node* node) { return std::abs(text::parse_real(node->value).value_or(0.0)) > kLongestDistance; });
  return beyond == translation.end() ? *translation.front() : **beyond;
}

}  // namespace

const PoseEdge* edge_of(const Rig& rig, std::string_view a, std::string_view b) {
  const auto found = std::ranges::find_if(rig.poses, [&](const PoseEdge& edge) { return edge.a == a && edge.b == b; });
  return found == rig.poses.end() ? nullptr : &*found;
}

PoseFrame::PoseFrame(const Rig& rig, const PoseLayout& layout)
    : rig_(rig),
      name_(layout.kind == FrameKind::kImu && !rig.imus.empty() ? rig.imus.front().name : std::string(layout.frame)) {
  known_ = std::ranges::any_of(rig.cameras, [this](const Camera& camera) { return pose(camera).has_value(); });
  if (!known_) name_ = rig.cameras.front().name;
}

std::optional<Transform> PoseFrame::pose(const Camera& camera) const {
  const Transform* stated = rig_.stated(name_, camera.name);
  return stated != nullptr ? *stated : rig_.resolve(name_, camera.name);
}

void PoseFrame::report_assumed_pose(std::string_view key, const PoseLayout& layout, const Camera& camera,
                                    Written& written) const {
  const bool has_pose = pose(camera).has_value();
  if (known_ && has_pose) return;
  const bool in_other_camera = has_pose && name_ != camera.name;
  const Message value = in_other_camera ? Message{layout.in_frame, {name_}} : Message{layout.identity};
  const Code made_up = layout.made_up;
  written.defaults.push_back(
      {camera.name + " " + std::string(key), made_up != Code{} ? Message{made_up, {value}} : value, true, true});
}

bool read_pose(Reading& reading, const Key& key, const Node& node) {
  const PoseLayout& layout = *key.with.pose;
  const std::string what = reading.label(key);
  if (!node.is_mapping()) {
    reading.reader.say(node, layout.no_pose, {what});
    return false;
  }
  const std::optional<std::vector<double>> n = read_numbers(reading, key, node);
  if (!n) return false;
  const text::Dialect dialect = reading.reader.dialect();
  const Node& rotation = *numbers_of(node, layout.rotation, dialect).front();
  const std::optional<Quaternion> q = unit_quaternion(reading, key, {(*n)[3], (*n)[4], (*n)[5], (*n)[6]}, rotation);
  if (!q) return false;
  const Node& translation = coordinate_beyond_limit(numbers_of(node, layout.translation, dialect));
  return add_pose(reading, layout, pose_of(*q, {(*n)[0], (*n)[1], (*n)[2]}), {rotation, what}, {translation, what});
}

bool add_pose(Reading& reading, const PoseLayout& layout, const Transform& T, const fields::Reader::Place& rotation,
              const fields::Reader::Place& translation) {
  const std::optional<Transform> checked = reading.reader.checked(T, rotation, translation);
  if (!checked) return false;
  reading.rig.poses.push_back({std::string(layout.frame), reading.camera->name, *checked});
  reading.rig.add_frame(layout.frame, layout.kind);
  return true;
}

/// Writes the pose of a camera in the frame of PoseFrame; the identity if the pose is not known. For a fresh file, reports
/// assumed and rounded poses.
std::vector<Statement> write_pose(const Subject& subject, const Key& key) {
  const Camera& camera = subject.the_camera();
  const PoseFrame frame(subject.rig, *key.with.pose);
  const std::optional<Transform> T = frame.pose(camera);
  if (subject.fresh != nullptr) {
    frame.report_assumed_pose(key.name, *key.with.pose, camera, *subject.fresh);
    if (T) report_rounded_pose(frame, key, camera, *T, *subject.fresh);
  }
  const PoseLayout& layout = *key.with.pose;
  const PoseEdge* edge = edge_of(subject.rig, layout.frame, camera.name);
  std::vector<Statement> first = translation_of_pose(layout, T.value_or(Transform{}), edge);
  std::vector<Statement> second = rotation_of_pose(layout, quaternion_for(layout, T.value_or(Transform{})), edge);
  if (layout.rotation_first) std::swap(first, second);
  std::ranges::move(second, std::back_inserter(first));
  return first;
}

void edit_pose(text::Document& document, const Node& node, const Key& key, const Subject& before, const Subject& after,
               Written& written) {
  const PoseLayout& layout = *key.with.pose;
  const text::Dialect dialect = after.schema.dialect;
  const PoseFrame frame(after.rig, layout);
  const std::optional<Transform> now = frame.own_pose(after.the_camera());
  const Transform* old = before.rig.stated(layout.frame, before.the_camera().name);
  if (!now || (old != nullptr && *old == *now) || node.entries.empty()) return;
  const auto apply = [&](const std::vector<Statement>& from, const std::vector<Statement>& to) {
    fields::apply(document, node, dialect, fields_of(from), fields_of(to));
  };
  // The file has keys of a pose, but no pose could be read from them.
  if (old == nullptr) return apply({}, write_pose(after, key));
  apply(translation_of_pose(layout, *old, nullptr), translation_of_pose(layout, *now, nullptr));
  if (largest_difference(*old, *now).distance <= kSameRotation) return;
  // q and -q are the same rotation: signed_as() chooses the one that is nearer to the numbers in the file.
  const Quaternion in_file = quaternion_in_file(node, layout, dialect);
  apply(rotation_of_pose(layout, in_file, nullptr),
        rotation_of_pose(layout, signed_as(quaternion_for(layout, *now), in_file), nullptr));
  report_rounded_pose(frame, key, after.the_camera(), *now, written);
}

bool have_positive_determinants(const Rig& rig, const PoseLayout& layout, Code code, Diagnostics& diagnostics) {
  const PoseFrame frame(rig, layout);
  bool good = true;
  for (const Camera& camera : rig.cameras) {
    const std::optional<Transform> T = frame.pose(camera);
    if (!T || rotation_determinant(*T) > 0.0) continue;
    diagnostics.add(code, {camera.name, frame.name()});
    good = false;
  }
  return good;
}

}  // namespace fca::schema
