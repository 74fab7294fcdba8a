// SPDX-License-Identifier: BSD-3-Clause
// Rows of a camera: its lens, its parameters, its image, its clock.
#include "keys.h"

#include <fca/formats/text/numbers.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <cmath>

namespace fca::schema {

using text::Node;

namespace {

constexpr std::size_t kLongestWord = 40;  ///< Of the file, in a message.

std::string_view lens_of(const Camera& camera, const Key& key) {
  const auto found = std::ranges::find(key.lenses, model_info(camera.model).id, &Lens::model);
  return found == key.lenses.end() ? std::string_view() : found->name;
}

/// The keys that lenses have beside their parameters.
bool is_further(const Key& key, std::string_view name) {
  return !name.empty() && std::ranges::find(key.lenses, name, &Lens::further) != key.lenses.end();
}

/// Entries beside the parameters: a limit of a lens is kept where it is one, of others is said that nobody reads them.
void read_further(Reading& reading, const Key& key, const Node& node) {
  const auto& parameters = model_info(reading.camera->model).parameters;
  for (const text::Entry& entry : node.entries) {
    const std::string& name = entry.key.value;
    if (std::ranges::find(parameters, name, &Parameter::name) != parameters.end()) continue;
    if (!is_further(key, name)) {
      reading.reader.say(entry.key, reading.schema.codes.unknown_parameter,
                         {reading.camera->name, name.substr(0, kLongestWord), reading.lens});
    } else if (reading.reader.find(node, name) == &entry.value && text::parse_real(entry.value.value) > 0.0) {
      reading.rig.extra_fields.push_back({reading.camera->name, name, entry.value.value});
    }
  }
}

/// The first time offset that is stated, in the file's unit.
std::optional<double> common_offset(const Rig& rig) {
  const auto stated = std::ranges::find_if(rig.cameras, [](const Camera& camera) { return camera.time_offset_s.has_value(); });
  return stated == rig.cameras.end() ? std::nullopt : stated->time_offset_s;
}

}  // namespace

bool read_lens_name(Reading& reading, const Key& key, const Node& node) {
  const auto lens = std::ranges::find(key.lenses, node.value, &Lens::name);
  if (lens == key.lenses.end()) {
    reading.reader.say(node, reading.schema.codes.unknown_model, {reading.camera->name, node.value.substr(0, kLongestWord)});
    return false;
  }
  reading.camera->model = make_model(lens->model).value();
  reading.lens = lens->name;
  return true;
}

std::vector<Statement> write_lens_name(const Subject& subject, const Key& key) {
  return {{fields::quoted(std::string(key.name), lens_of(subject.the_camera(), key)), {{FactKind::kModel}}}};
}

bool read_parameters(Reading& reading, const Key& key, const Node& node) {
  if (reading.lens.empty()) return false;
  const std::string owner = reading.label(key);
  if (!node.is_mapping()) {
    reading.reader.say(node, reading.schema.codes.no_object, {owner});
    return false;
  }
  bool good = true;
  Camera& camera = *reading.camera;
  for (const Parameter& parameter : model_info(camera.model).parameters) {
    const Node* number = reading.reader.require(node, parameter.name, owner);
    good = number != nullptr && reading.reader.parameter(*number, camera.name, ParameterId(parameter), camera.model) && good;
  }
  read_further(reading, key, node);
  return good;
}

std::vector<Statement> write_parameters(const Subject& subject, const Key& key) {
  const CameraModel& model = subject.the_camera().model;
  std::vector<Statement> statements;
  for (const Parameter& parameter : model_info(model).parameters) {
    const double value = fca::parameter(model, ParameterId(parameter)).value();
    statements.push_back(
        {fields::real(std::string(parameter.name), value), {{.kind = FactKind::kParameter, .parameter = parameter.name}}});
  }
  const auto lens = std::ranges::find(key.lenses, model_info(model).id, &Lens::model);
  if (lens != key.lenses.end() && !lens->further.empty())
    statements.push_back({fields::real(std::string(lens->further), lens->none)});
  return statements;
}

bool read_image_size(Reading& reading, const Key& key, const Node& node) {
  if (!node.is_sequence() || node.items.size() != 2) {
    reading.reader.say(node, reading.schema.codes.no_size, {reading.camera->name});
    return false;
  }
  reading.camera->image_size = reading.reader.image_size(node.items[0], node.items[1], reading.label(key) + " ");
  return reading.camera->image_size.has_value();
}

std::vector<Statement> write_image_size(const Subject& subject, const Key& key) {
  const std::optional<ImageSize>& size = subject.the_camera().image_size;
  if (!size) return {};
  fields::Field field;
  field.key = key.name;
  field.shape = fields::Shape::kList;
  field.tokens = {std::to_string(size->width), std::to_string(size->height)};
  return {{std::move(field), {{.kind = FactKind::kImageSize, .row = 0}, {.kind = FactKind::kImageSize, .row = 1}}}};
}

bool read_time_offset(Reading& reading, const Key& key, const Node& node) {
  const std::optional<double> offset = reading.reader.real(node, key.name);
  if (!offset) return false;
  if (*offset != std::floor(*offset)) {
    reading.reader.say(node, reading.schema.codes.offset_not_whole, {key.name, node.value});
    return false;
  }
  const double seconds = *offset / key.per_second;
  if (const Message problem = problem_with_time_offset(seconds); problem.is_said()) {
    reading.reader.say(node, reading.schema.codes.offset_invalid, {key.name, problem});
    return false;
  }
  for (Camera& camera : reading.rig.cameras) camera.time_offset_s = seconds;
  return true;
}

std::vector<Statement> write_time_offset(const Subject& subject, const Key& key) {
  const long long offset = std::llround(common_offset(subject.rig).value_or(0.0) * key.per_second);
  return {{fields::scalar(std::string(key.name), std::to_string(offset)), {{FactKind::kTimeOffset}}}};
}

}  // namespace fca::schema
