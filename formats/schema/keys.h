// SPDX-License-Identifier: BSD-3-Clause
// Rows of tables (schema.h) that formats share. First come the functions of rows: read_...() and write_...() have the contracts
// of Key::read and Key::write. The constexpr functions after them make the rows.
#pragma once

#include "schema.h"

#include <fca/rig/rotation.h>

namespace fca::schema {

/// The name that the only IMU of a file gets if the file does not name it.
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
/// The rig's extra field for a row made by tuning(). Null if the rig has none, or if its value is neither a number nor a list
/// of numbers: such text is not copied into a fresh file.
const ExtraField* kept_tuning(const Rig& rig, const Key& key);
/// Reads a value as an extra field of the camera being read, or of the file.
bool keep(Reading& reading, const Key& key, const text::Node& node);
/// Reads `key.with.count` numbers as an extra field of the IMU, unless all are 0.
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

/// Edits the numbers of a pose. The numbers of the rotation change only if the rotation itself changes. So a rotation that was
/// printed with few digits keeps its digits, although the rig's rotation is rounded differently.
void edit_pose(text::Document& document, const text::Node& node, const Key& key, const Subject& before, const Subject& after,
               Written& written);

/// A key whose value is an object with the given keys.
constexpr Key object(std::string_view name, const Mapping& mapping) {
  return {name, FactKind::kOther, read_object, nullptr, {.mapping = &mapping}};
}

/// The camera's name in the file. An edit does not change it.
constexpr Key camera_name(std::string_view name) { return {name, FactKind::kOther, read_camera_name, write_camera_name}; }

/// The program's name for the camera's lens.
constexpr Key lens_name(std::string_view name, std::span<const Lens> lenses) {
  return {name, FactKind::kModel, read_lens_name, write_lens_name, {.lenses = lenses}};
}

/// An object with the lens's parameters, under the names that our models use for these parameters.
constexpr Key parameters(std::string_view name, std::span<const Lens> lenses) {
  return {name, FactKind::kParameter, read_parameters, write_parameters, {.lenses = lenses}, nullptr, true};
}

/// The value of one lens parameter.
constexpr Key parameter(std::string_view name, ParameterId id) {
  return {name, FactKind::kParameter, read_parameter, write_parameter, {.parameter = id}};
}

/// The width of the image [px]. The row of the height reads both. `real`: the number is written with a decimal point.
constexpr Key image_width(std::string_view name, bool real) {
  return {name, FactKind::kImageSize, nullptr, write_image_width, {.real = real}};
}
/// The height of the image [px]. `width`: the key of the width.
constexpr Key image_height(std::string_view name, std::string_view width, bool real) {
  return {name, FactKind::kImageSize, read_image_sides, write_image_height, {.other = width, .real = real}};
}

/// The list [width, height] of the image [px].
constexpr Key image_size(std::string_view name) { return {name, FactKind::kImageSize, read_image_size, write_image_size}; }

/// An object that contains the pose T_frame_camera. read_pose() reads only layouts with one key per number; a row for a layout
/// with lists needs a `read` of its own.
constexpr Key pose(std::string_view name, const PoseLayout& layout) {
  return {name, FactKind::kPose, read_pose, write_pose, {.pose = &layout}, edit_pose, true};
}

/// The camera's time offset, t_imu = t_cam + offset [s].
constexpr Key time_offset(std::string_view name) { return {name, FactKind::kTimeOffset, read_time_offset, write_time_offset}; }

/// A single time offset for all cameras, t_imu = t_cam + offset, as a whole number of units. `per_second`: the number of units
/// in a second, e.g. 1e9 for nanoseconds.
constexpr Key common_time_offset(std::string_view name, double per_second) {
  return {name, FactKind::kTimeOffset, read_common_offset, write_common_offset, {.per_second = per_second}};
}

/// The delay of all cameras' time stamps [s]: t_imu = t_cam - delay.
constexpr Key common_delay(std::string_view name) {
  return {name, FactKind::kTimeOffset, read_common_delay, write_common_delay};
}

/// A noise density of the IMU, in the unit of its Imu member: a list with the same number for each axis. Older files have a
/// single number instead. `initial`: the number in a fresh file if the rig has no value.
constexpr Key density(std::string_view name, std::optional<double> Imu::*member, std::size_t axes, double initial) {
  return {name, FactKind::kImu, read_density, write_density, {.imu = member, .count = axes, .initial = initial}};
}

/// A noise density or the rate [Hz] of the IMU, in the unit of its Imu member, as one number. `initial`: as for density().
constexpr Key imu_number(std::string_view name, std::optional<double> Imu::*member, double initial = 0.0) {
  return {name, FactKind::kImu, read_imu_number, write_imu_number, {.imu = member, .initial = initial}};
}

/// The camera's ROS topic, in quotes only where YAML needs them.
constexpr Key camera_topic(std::string_view name) { return {name, FactKind::kTopic, read_topic, write_topic}; }
/// The IMU's ROS topic, always in quotes.
constexpr Key imu_topic(std::string_view name) { return {name, FactKind::kTopic, read_topic, write_topic, {.of_imu = true}}; }

/// A list of `count` numbers of the IMU for which a rig has no member. The list is kept as an extra field unless all numbers
/// are 0.
constexpr Key kept_numbers(std::string_view name, std::size_t count) {
  return {name, FactKind::kOther, keep_numbers, write_kept_numbers, {.count = count}};
}

/// A value for which a rig has no member. It is kept as an extra field of the camera being read, or of the file. A fresh file
/// does not get this key.
constexpr Key kept(std::string_view name) { return {name, FactKind::kOther, keep}; }

/// The first of the two names of a camera's lens. The row of the second name reads both.
constexpr Key camera_model(std::string_view name, std::span<const ListLens> lenses) {
  return {name, FactKind::kModel, nullptr, write_camera_model, {.list_lenses = lenses}};
}
/// The second name of a camera's lens. `camera_model`: the key of the first name. `list`: the key of the coefficients.
constexpr Key distortion_model(std::string_view name, std::string_view camera_model, std::string_view list,
                               std::span<const ListLens> lenses) {
  return {
      name, FactKind::kModel, read_list_lens, write_list_lens, {.list_lenses = lenses, .other = camera_model, .list = list}};
}

/// The list [fx, fy, cx, cy]. In the table this row comes after those of the lens's names.
constexpr Key focal_and_centre(std::string_view name) {
  return {name, FactKind::kParameter, read_focal_and_centre, write_focal_and_centre};
}
/// The list of the distortion coefficients. In the table this row comes after those of the lens's names.
constexpr Key coefficients(std::string_view name, std::span<const ListLens> lenses) {
  return {name, FactKind::kParameter, read_coefficients, write_coefficients, {.list_lenses = lenses}};
}

/// The camera's frame rate [Hz].
constexpr Key frame_rate(std::string_view name) { return {name, FactKind::kFrameRate, read_frame_rate, write_frame_rate}; }

/// The number of rows or columns of a 4 x 4 matrix.
constexpr Key side_of_four(std::string_view name) { return {name, FactKind::kOther, read_side_of_four, write_side_of_four}; }

/// The pose T_frame_camera as 16 numbers, row-major. `owner`: the key of the object that contains the matrix. Messages about an
/// assumed pose name it.
constexpr Key matrix(std::string_view name, std::string_view owner, const PoseLayout& layout) {
  return {name, FactKind::kPose, read_matrix, write_matrix, {.pose = &layout, .other = owner}};
}
/// The pose T_frame_imu of an IMU as 16 numbers, row-major.
constexpr Key imu_matrix(std::string_view name, const PoseLayout& layout) {
  return {name, FactKind::kPose, read_imu_matrix, write_imu_matrix, {.pose = &layout}};
}
/// The pose of the IMU that is itself the frame, as 16 numbers. Any other matrix than the identity is an error.
constexpr Key identity(std::string_view name) { return {name, FactKind::kOther, read_identity, write_identity}; }

/// A key whose value is not read. A fresh file gets `token`.
constexpr Key fixed(std::string_view name, std::string_view token) {
  return {name, FactKind::kOther, read_fixed, write_fixed, {.token = token}};
}
/// A key whose value is not read and which a fresh file does not get.
constexpr Key unread(std::string_view name) { return {name, FactKind::kOther, read_fixed}; }

/// A setting of the program. It is kept as an extra field of the file, whose key begins with `prefix` ("kimera.n_gravity"), and
/// a fresh file gets that value again. If the rig has no such field, the fresh file gets `token`, which is listed as a default.
constexpr Key tuning(std::string_view name, std::string_view prefix, std::string_view token) {
  return {name, FactKind::kOther, read_tuning, write_tuning, {.other = prefix, .token = token}};
}

/// The row `key`, changed so that only edits write it: a fresh file does not get it.
constexpr Key only_edited(Key key) {
  key.with.only_edited = true;
  return key;
}
/// The row `key`, changed so that an error is added if the file does not have it.
constexpr Key required(Key key) {
  key.need = Need::kRequired;
  return key;
}
/// The row `key`, changed so that a warning is added if the file does not have it.
constexpr Key wanted(Key key) {
  key.need = Need::kWanted;
  return key;
}

/// The row of a list with one item for each camera. `item`: the row of one item.
constexpr Key per_camera(Spread spread, Key item) {
  item.spread = spread;
  return item;
}

/// The frame in which the poses of a rig's cameras are written: the layout's frame or, if no camera has a known pose in it, the
/// first camera. (Identities in the layout's frame would mean that all cameras are at the same place.) If the layout's frame is
/// an IMU, the rig's first IMU is used, whatever its name.
class PoseFrame {
 public:
  PoseFrame(const Rig& rig, const PoseLayout& layout);
  /// True if the pose of at least one camera is known in the layout's frame.
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// T_frame_camera, as the rig contains it or as a product of its poses; nullopt if it is not known.
  [[nodiscard]] std::optional<Transform> pose(const Camera& camera) const;
  /// The result of pose(), but nullopt if the frame is the first camera because no pose is known in the layout's frame.
  [[nodiscard]] std::optional<Transform> own_pose(const Camera& camera) const { return known_ ? pose(camera) : std::nullopt; }
  /// Reports in `written.defaults` that the file gets a pose under `key` that the rig does not have: the identity, or a pose in
  /// another frame than the layout's. Does nothing if the rig has the pose.
  void report_assumed_pose(std::string_view key, const PoseLayout& layout, const Camera& camera, Written& written) const;

 private:
  const Rig& rig_;
  std::string name_;
  bool known_ = false;
};

/// The rig's pose T_a_b if the rig contains it in this direction; otherwise null. Its inverse T_b_a is not used.
[[nodiscard]] const PoseEdge* edge_of(const Rig& rig, std::string_view a, std::string_view b);

/// Adds T as the pose T_frame_camera of the camera being read. False, with errors at the nodes of its rotation or translation,
/// if T is not a valid pose.
bool add_pose(Reading& reading, const PoseLayout& layout, const Transform& T, const fields::Reader::Place& rotation,
              const fields::Reader::Place& translation);

/// True if the matrix of every camera's pose has a positive determinant. Otherwise false, with an error `code` for each pose
/// that has not: no quaternion can represent a mirror image. Arguments of the message: {0} the camera, {1} the frame.
[[nodiscard]] bool have_positive_determinants(const Rig& rig, const PoseLayout& layout, Code code, Diagnostics& diagnostics);

}  // namespace fca::schema
