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
bool read_image_size(Reading& reading, const Key& key, const text::Node& node);
bool read_time_offset(Reading& reading, const Key& key, const text::Node& node);
bool read_pose(Reading& reading, const Key& key, const text::Node& node);
bool read_density(Reading& reading, const Key& key, const text::Node& node);
bool read_rate(Reading& reading, const Key& key, const text::Node& node);
bool keep(Reading& reading, const Key& key, const text::Node& node);
bool keep_numbers(Reading& reading, const Key& key, const text::Node& node);

std::vector<Statement> write_lens_name(const Subject& subject, const Key& key);
std::vector<Statement> write_parameters(const Subject& subject, const Key& key);
std::vector<Statement> write_image_size(const Subject& subject, const Key& key);
std::vector<Statement> write_time_offset(const Subject& subject, const Key& key);
std::vector<Statement> write_pose(const Subject& subject, const Key& key);
std::vector<Statement> write_density(const Subject& subject, const Key& key);
std::vector<Statement> write_rate(const Subject& subject, const Key& key);
std::vector<Statement> write_kept_numbers(const Subject& subject, const Key& key);

/// Numbers of the translation, and those of the rotation where it is another one: what it rounds, a rotation printed with few
/// digits, is not edited for that.
void edit_pose(text::Document& document, const text::Node& node, const Key& key, const Subject& before, const Subject& after,
               Written& written);

/// An object with keys of its own.
constexpr Key object(std::string_view name, const Mapping& mapping) {
  return {.name = name, .read = read_object, .mapping = &mapping};
}

/// What the program calls the camera's lens.
constexpr Key lens_name(std::string_view name, std::span<const Lens> lenses) {
  return {.name = name, .fact = FactKind::kModel, .read = read_lens_name, .write = write_lens_name, .lenses = lenses};
}

/// An object with the lens's parameters by our names.
constexpr Key parameters(std::string_view name, std::span<const Lens> lenses) {
  return {.name = name,
          .fact = FactKind::kParameter,
          .read = read_parameters,
          .write = write_parameters,
          .inside = true,
          .lenses = lenses};
}

/// [width, height]
constexpr Key image_size(std::string_view name) {
  return {.name = name, .fact = FactKind::kImageSize, .read = read_image_size, .write = write_image_size};
}

/// An object that states T_frame_camera.
constexpr Key pose(std::string_view name, const PoseLayout& layout) {
  return {.name = name,
          .fact = FactKind::kPose,
          .read = read_pose,
          .write = write_pose,
          .edit = edit_pose,
          .inside = true,
          .pose = &layout};
}

/// A noise density of the IMU in our unit: a list with the same number for each axis. Older files have one number for all.
constexpr Key density(std::string_view name, std::optional<double> Imu::*member, std::size_t axes, double initial) {
  return {.name = name,
          .fact = FactKind::kImu,
          .read = read_density,
          .write = write_density,
          .imu = member,
          .count = axes,
          .initial = initial};
}

/// The IMU's rate [Hz].
constexpr Key rate(std::string_view name, double initial) {
  return {
      .name = name, .fact = FactKind::kImu, .read = read_rate, .write = write_rate, .imu = &Imu::rate_hz, .initial = initial};
}

/// The time offset of all cameras, t_imu = t_cam + offset, in whole units (1e9 per second: nanoseconds).
constexpr Key common_time_offset(std::string_view name, double per_second) {
  return {.name = name,
          .fact = FactKind::kTimeOffset,
          .read = read_time_offset,
          .write = write_time_offset,
          .per_second = per_second};
}

/// `count` numbers of the IMU that a rig has no member for, as an extra field; zeros say nothing.
constexpr Key kept_numbers(std::string_view name, std::size_t count) {
  return {.name = name, .read = keep_numbers, .write = write_kept_numbers, .count = count};
}

/// What a rig has no member for: an extra field, of the camera where it is a camera's. A fresh file has none.
constexpr Key kept(std::string_view name) { return {.name = name, .read = keep}; }

constexpr Key required(Key key) {
  key.required = true;
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

 private:
  const Rig& rig_;
  std::string name_;
  bool known_ = false;
};

/// An error for each pose that is a mirror image, which no quaternion says: false then. `code`: {0} the camera, {1} the frame.
[[nodiscard]] bool are_rotations(const Rig& rig, const PoseLayout& layout, Code code, Diagnostics& diagnostics);

}  // namespace fca::schema
