// SPDX-License-Identifier: BSD-3-Clause
// The rows that formats share.
#pragma once

#include "schema.h"

#include <fca/rig/rotation.h>

namespace fca::schema {

/// The name of the only IMU of a file that does not name it.
inline constexpr std::string_view kImu = "imu0";

bool read_object(Reading& reading, const Key& key, const text::Node& node);
bool read_lens_name(Reading& reading, const Key& key, const text::Node& node);
bool read_parameters(Reading& reading, const Key& key, const text::Node& node);
bool read_camera_name(Reading& reading, const Key& key, const text::Node& node);
bool read_parameter(Reading& reading, const Key& key, const text::Node& node);
bool read_image_sides(Reading& reading, const Key& key, const text::Node& node);
bool read_image_size(Reading& reading, const Key& key, const text::Node& node);
bool read_time_offset(Reading& reading, const Key& key, const text::Node& node);
bool read_common_offset(Reading& reading, const Key& key, const text::Node& node);
bool read_common_delay(Reading& reading, const Key& key, const text::Node& node);
bool read_topic(Reading& reading, const Key& key, const text::Node& node);
bool read_pose(Reading& reading, const Key& key, const text::Node& node);
bool read_density(Reading& reading, const Key& key, const text::Node& node);
bool read_imu_number(Reading& reading, const Key& key, const text::Node& node);
bool read_list_lens(Reading& reading, const Key& key, const text::Node& node);
bool read_focal_and_centre(Reading& reading, const Key& key, const text::Node& node);
bool read_coefficients(Reading& reading, const Key& key, const text::Node& node);
bool read_frame_rate(Reading& reading, const Key& key, const text::Node& node);
bool read_side_of_four(Reading& reading, const Key& key, const text::Node& node);
bool read_matrix(Reading& reading, const Key& key, const text::Node& node);
bool read_identity(Reading& reading, const Key& key, const text::Node& node);
bool read_imu_matrix(Reading& reading, const Key& key, const text::Node& node);
bool read_fixed(Reading& reading, const Key& key, const text::Node& node);
bool read_tuning(Reading& reading, const Key& key, const text::Node& node);
/// What the rig keeps of such a key from a file that had it; null if nothing, or if it is no number nor a list of numbers,
/// which a fresh file cannot be trusted with.
const ExtraField* kept_tuning(const Rig& rig, const Key& key);
bool keep(Reading& reading, const Key& key, const text::Node& node);
bool keep_numbers(Reading& reading, const Key& key, const text::Node& node);

std::vector<Statement> write_lens_name(const Subject& subject, const Key& key);
std::vector<Statement> write_parameters(const Subject& subject, const Key& key);
std::vector<Statement> write_camera_name(const Subject& subject, const Key& key);
std::vector<Statement> write_parameter(const Subject& subject, const Key& key);
std::vector<Statement> write_image_width(const Subject& subject, const Key& key);
std::vector<Statement> write_image_height(const Subject& subject, const Key& key);
std::vector<Statement> write_image_size(const Subject& subject, const Key& key);
std::vector<Statement> write_time_offset(const Subject& subject, const Key& key);
std::vector<Statement> write_common_offset(const Subject& subject, const Key& key);
std::vector<Statement> write_common_delay(const Subject& subject, const Key& key);
std::vector<Statement> write_topic(const Subject& subject, const Key& key);
std::vector<Statement> write_pose(const Subject& subject, const Key& key);
std::vector<Statement> write_density(const Subject& subject, const Key& key);
std::vector<Statement> write_imu_number(const Subject& subject, const Key& key);
std::vector<Statement> write_list_lens(const Subject& subject, const Key& key);
std::vector<Statement> write_camera_model(const Subject& subject, const Key& key);
std::vector<Statement> write_focal_and_centre(const Subject& subject, const Key& key);
std::vector<Statement> write_coefficients(const Subject& subject, const Key& key);
std::vector<Statement> write_frame_rate(const Subject& subject, const Key& key);
std::vector<Statement> write_side_of_four(const Subject& subject, const Key& key);
std::vector<Statement> write_matrix(const Subject& subject, const Key& key);
std::vector<Statement> write_identity(const Subject& subject, const Key& key);
std::vector<Statement> write_imu_matrix(const Subject& subject, const Key& key);
std::vector<Statement> write_fixed(const Subject& subject, const Key& key);
std::vector<Statement> write_tuning(const Subject& subject, const Key& key);
std::vector<Statement> write_kept_numbers(const Subject& subject, const Key& key);

/// Numbers of the translation, and those of the rotation where it is another one: what it rounds, a rotation printed with few
/// digits, is not edited for that.
void edit_pose(text::Document& document, const text::Node& node, const Key& key, const Subject& before, const Subject& after,
               Written& written);

/// An object with keys of its own.
constexpr Key object(std::string_view name, const Mapping& mapping) {
  return {name, FactKind::kOther, read_object, nullptr, {.mapping = &mapping}};
}

/// What the file calls the camera. An edit leaves it.
constexpr Key camera_name(std::string_view name) { return {name, FactKind::kOther, read_camera_name, write_camera_name}; }

/// What the program calls the camera's lens.
constexpr Key lens_name(std::string_view name, std::span<const Lens> lenses) {
  return {name, FactKind::kModel, read_lens_name, write_lens_name, {.lenses = lenses}};
}

/// An object with the lens's parameters by our names.
constexpr Key parameters(std::string_view name, std::span<const Lens> lenses) {
  return {name, FactKind::kParameter, read_parameters, write_parameters, {.lenses = lenses}, nullptr, true};
}

/// One parameter.
constexpr Key parameter(std::string_view name, ParameterId id) {
  return {name, FactKind::kParameter, read_parameter, write_parameter, {.parameter = id}};
}

/// The width of the image, which is read with its height. `real`: with a point.
constexpr Key image_width(std::string_view name, bool real) {
  return {name, FactKind::kImageSize, nullptr, write_image_width, {.real = real}};
}
constexpr Key image_height(std::string_view name, std::string_view width, bool real) {
  return {name, FactKind::kImageSize, read_image_sides, write_image_height, {.other = width, .real = real}};
}

/// [width, height]
constexpr Key image_size(std::string_view name) { return {name, FactKind::kImageSize, read_image_size, write_image_size}; }

/// An object that states T_frame_camera.
constexpr Key pose(std::string_view name, const PoseLayout& layout) {
  return {name, FactKind::kPose, read_pose, write_pose, {.pose = &layout}, edit_pose, true};
}

/// The camera's time offset, t_imu = t_cam + offset [s].
constexpr Key time_offset(std::string_view name) { return {name, FactKind::kTimeOffset, read_time_offset, write_time_offset}; }

/// The time offset of all cameras, t_imu = t_cam + offset, in whole units (1e9 per second: nanoseconds).
constexpr Key common_time_offset(std::string_view name, double per_second) {
  return {name, FactKind::kTimeOffset, read_common_offset, write_common_offset, {.per_second = per_second}};
}

/// The delay of all cameras' stamps [s]: t_imu = t_cam - delay.
constexpr Key common_delay(std::string_view name) {
  return {name, FactKind::kTimeOffset, read_common_delay, write_common_delay};
}

/// A noise density of the IMU in our unit: a list with the same number for each axis. Older files have one number for all.
constexpr Key density(std::string_view name, std::optional<double> Imu::*member, std::size_t axes, double initial) {
  return {name, FactKind::kImu, read_density, write_density, {.imu = member, .count = axes, .initial = initial}};
}

/// A noise density or the rate of the IMU in our unit, as one number.
constexpr Key imu_number(std::string_view name, std::optional<double> Imu::*member, double initial = 0.0) {
  return {name, FactKind::kImu, read_imu_number, write_imu_number, {.imu = member, .initial = initial}};
}

/// A ROS topic of the camera, without quotes where it needs none; of the IMU.
constexpr Key camera_topic(std::string_view name) { return {name, FactKind::kTopic, read_topic, write_topic}; }
constexpr Key imu_topic(std::string_view name) { return {name, FactKind::kTopic, read_topic, write_topic, {.of_imu = true}}; }

/// `count` numbers of the IMU that a rig has no member for, as an extra field; zeros say nothing.
constexpr Key kept_numbers(std::string_view name, std::size_t count) {
  return {name, FactKind::kOther, keep_numbers, write_kept_numbers, {.count = count}};
}

/// What a rig has no member for: an extra field, of the camera where it is a camera's. A fresh file has none.
constexpr Key kept(std::string_view name) { return {name, FactKind::kOther, keep}; }

/// The two names of a camera's lens; the second row reads both. `list`: the key of the coefficients.
constexpr Key camera_model(std::string_view name, std::span<const ListLens> lenses) {
  return {name, FactKind::kModel, nullptr, write_camera_model, {.list_lenses = lenses}};
}
constexpr Key distortion_model(std::string_view name, std::string_view camera_model, std::string_view list,
                               std::span<const ListLens> lenses) {
  return {
      name, FactKind::kModel, read_list_lens, write_list_lens, {.list_lenses = lenses, .other = camera_model, .list = list}};
}

/// [fx, fy, cx, cy], and the lens's coefficients; both after the row of its names.
constexpr Key focal_and_centre(std::string_view name) {
  return {name, FactKind::kParameter, read_focal_and_centre, write_focal_and_centre};
}
constexpr Key coefficients(std::string_view name, std::span<const ListLens> lenses) {
  return {name, FactKind::kParameter, read_coefficients, write_coefficients, {.list_lenses = lenses}};
}

/// The camera's images per second.
constexpr Key frame_rate(std::string_view name) { return {name, FactKind::kFrameRate, read_frame_rate, write_frame_rate}; }

/// The number of rows or columns of such a matrix.
constexpr Key side_of_four(std::string_view name) { return {name, FactKind::kOther, read_side_of_four, write_side_of_four}; }

/// 16 numbers, row by row: T_frame_camera, T_frame_imu, or an IMU's that is the frame. `owner`: the key that they stand below.
constexpr Key matrix(std::string_view name, std::string_view owner, const PoseLayout& layout) {
  return {name, FactKind::kPose, read_matrix, write_matrix, {.pose = &layout, .other = owner}};
}
constexpr Key imu_matrix(std::string_view name, const PoseLayout& layout) {
  return {name, FactKind::kPose, read_imu_matrix, write_imu_matrix, {.pose = &layout}};
}
constexpr Key identity(std::string_view name) { return {name, FactKind::kOther, read_identity, write_identity}; }

/// A key without a fact, and the word that a fresh file has there.
constexpr Key fixed(std::string_view name, std::string_view token) {
  return {name, FactKind::kOther, read_fixed, write_fixed, {.token = token}};
}
/// A key without a fact, which a fresh file does not have.
constexpr Key unread(std::string_view name) { return {name, FactKind::kOther, read_fixed}; }

/// What tunes the program: an extra field of the file ("kimera.n_gravity" with the prefix "kimera."), which a fresh file says
/// again; else `token`, as a default.
constexpr Key tuning(std::string_view name, std::string_view prefix, std::string_view token) {
  return {name, FactKind::kOther, read_tuning, write_tuning, {.other = prefix, .token = token}};
}

/// The row of a key that a fresh file does not have.
constexpr Key only_edited(Key key) {
  key.with.only_edited = true;
  return key;
}
constexpr Key required(Key key) {
  key.need = Need::kRequired;
  return key;
}
constexpr Key wanted(Key key) {
  key.need = Need::kWanted;
  return key;
}

/// The row for an item of a list of all cameras.
constexpr Key per_camera(Spread spread, Key item) {
  item.spread = spread;
  return item;
}

/// In what frame the poses of a rig's cameras are written: the layout's, else the first camera's, where none of them is known
/// in the former. Identities for all would state that they sit in one place.
class PoseFrame {
 public:
  PoseFrame(const Rig& rig, const PoseLayout& layout);
  /// Is any camera's pose in the layout's own frame known?
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// T_frame_camera
  [[nodiscard]] std::optional<Transform> pose(const Camera& camera) const;
  /// The same in the layout's own frame only.
  [[nodiscard]] std::optional<Transform> own_pose(const Camera& camera) const { return known_ ? pose(camera) : std::nullopt; }
  /// Notes for a fresh file that the pose under that key is stated by no input, or in another frame than the layout's.
  void list_made_up(std::string_view key, const PoseLayout& layout, const Camera& camera, Written& written) const;

 private:
  const Rig& rig_;
  std::string name_;
  bool known_ = false;
};

/// The rig's T_a_b as it was read; null if there is none.
[[nodiscard]] const PoseEdge* edge_of(const Rig& rig, std::string_view a, std::string_view b);

/// Adds the pose of the camera that is read. False, with errors at the parts, where it is none.
bool add_pose(Reading& reading, const PoseLayout& layout, const Transform& T, const fields::Reader::Place& rotation,
              const fields::Reader::Place& translation);

/// An error for each pose that is a mirror image, which no quaternion says: false then. `code`: {0} the camera, {1} the frame.
[[nodiscard]] bool are_rotations(const Rig& rig, const PoseLayout& layout, Code code, Diagnostics& diagnostics);

}  // namespace fca::schema
