// SPDX-License-Identifier: BSD-3-Clause
// Functions that read and write the IMU's keys, and keys whose values a rig keeps as extra fields.
#include "keys.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>

namespace fca::schema {

using text::Node;

namespace {

/// The IMU whose keys are being read. If reading.imu is null, it is the only IMU of the file, which is added to the rig
/// for its first key.
Imu& imu_of(Reading& reading) {
  if (reading.imu != nullptr) return *reading.imu;
  if (reading.rig.imus.empty()) reading.rig.imus.emplace_back().name = kImu;
  return reading.rig.imus.front();
}

/// The rig's value of an IMU member. If the rig has none: in a fresh file the program's initial value, which is reported as a
/// default, and in an edit nullopt.
std::optional<double> value_of(const Subject& subject, const Key& key) {
  const std::optional<double> known =
      subject.imu < subject.rig.imus.size() ? subject.rig.imus[subject.imu].*key.with.imu : std::nullopt;
  if (known || subject.fresh == nullptr) return known;
  const Message value{subject.schema.codes.initial_value, {key.with.initial, subject.schema.program}};
  subject.fresh->defaults.push_back({key.text(), value, true, true});
  return key.with.initial;
}

Fact fact_of(const Key& key) { return {.kind = FactKind::kImu, .imu = key.with.imu}; }

/// The numbers of the key, which the rig keeps as an extra field. Zeros if there is no such field, or if it has another length.
std::vector<double> kept_numbers_of(const Rig& rig, const Key& key) {
  const ExtraField* extra = rig.find_extra_field(kImu, key.name);
  const std::vector<double> none(key.with.count, 0.0);
  const std::vector<double> kept = extra != nullptr ? text::reals_in(extra->value).value_or(none) : none;
  return kept.size() == key.with.count ? kept : none;
}

}  // namespace

bool read_imu_number(Reading& reading, const Key& key, const Node& node) {
  std::optional<double>& member = imu_of(reading).*key.with.imu;
  member = reading.reader.positive(node, reading.label(key));
  return member.has_value();
}

std::vector<Statement> write_imu_number(const Subject& subject, const Key& key) {
  const std::optional<double> value = value_of(subject, key);
  if (!value) return {};
  return states(fields::real(key.text(), *value), fact_of(key));
}

/// Reads one number for all axes, since a rig has no more. If the axes differ, the list becomes an extra field and the rig's
/// number stays unknown.
bool read_density(Reading& reading, const Key& key, const Node& node) {
  if (node.is_scalar()) return read_imu_number(reading, key, node);
  Imu& imu = imu_of(reading);
  if (!reading.reader.reals(node, key.with.count, reading.label(key))) return false;
  std::vector<double> axes;
  for (const Node& item : node.items) {
    const std::optional<double> axis = reading.reader.positive(item, reading.label(key));
    if (!axis) return false;
    axes.push_back(*axis);
  }
  if (std::ranges::all_of(axes, [&axes](double axis) { return axis == axes.front(); })) {
    imu.*key.with.imu = axes.front();
  } else {
    reading.rig.extra_fields.push_back({std::string(kImu), key.text(), fields::value_text(node)});
  }
  return true;
}

/// Writes the IMU's number once for each axis.
std::vector<Statement> write_density(const Subject& subject, const Key& key) {
  const std::optional<double> value = value_of(subject, key);
  if (!value) return {};
  return states(fields::list(key.text(), std::vector<double>(key.with.count, *value)), fact_of(key));
}

bool keep(Reading& reading, const Key& key, const Node& node) {
  const std::string owner = reading.camera != nullptr ? reading.camera->name : "";
  reading.rig.extra_fields.push_back({owner, key.text(), fields::value_text(node)});
  return true;
}

bool keep_numbers(Reading& reading, const Key& key, const Node& node) {
  const std::optional<std::vector<double>> numbers = reading.reader.reals(node, key.with.count, reading.label(key));
  if (!numbers) return false;
  if (std::ranges::any_of(*numbers, [](double number) { return number != 0.0; }))
    reading.rig.extra_fields.push_back({std::string(kImu), key.text(), fields::value_text(node)});
  return true;
}

/// Writes nothing in an edit, so that the file keeps its numbers.
std::vector<Statement> write_kept_numbers(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  return states(fields::list(key.text(), kept_numbers_of(subject.rig, key)));
}

}  // namespace fca::schema
