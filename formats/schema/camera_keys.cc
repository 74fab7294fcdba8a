// SPDX-License-Identifier: BSD-3-Clause
// Functions that read and write a camera's keys: lens, parameters, image size, topic and time offset. keys.h has the rows that
// use them.
#include "keys.h"

#include <fca/formats/text/numbers.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <cmath>

namespace fca::schema {

using text::Node;

namespace {

constexpr std::size_t kLongestQuote = 40;  ///< The largest number of characters of a file's text that a message quotes.

/// The program's name for the camera's lens; empty if the program has no such lens.
std::string_view lens_name_of(const Camera& camera, const Key& key) {
  const auto found = std::ranges::find(key.with.lenses, model_info(camera.model).id, &Lens::model);
  return found == key.with.lenses.end() ? std::string_view() : found->name;
}

/// True if a lens of the row has the additional key `name` (Lens::further).
bool is_further(const Key& key, std::string_view name) {
  return !name.empty() && std::ranges::find(key.with.lenses, name, &Lens::further) != key.with.lenses.end();
}

/// Reads the entries that are no parameters of the camera's model. A key of Lens::further becomes an extra field if its number
/// is positive; any other key gets a diagnostic.
void read_further(Reading& reading, const Key& key, const Node& node) {
  const auto& parameters = model_info(reading.camera->model).parameters;
  for (const text::Entry& entry : node.entries) {
    const std::string& name = entry.key.value;
    if (std::ranges::find(parameters, name, &Parameter::name) != parameters.end()) continue;
    if (!is_further(key, name)) {
      reading.reader.say(entry.key, reading.schema.codes.unknown_parameter,
                         {reading.camera->name, name.substr(0, kLongestQuote), reading.lens});
    } else if (reading.reader.find(node, name) == &entry.value && text::parse_real(entry.value.value) > 0.0) {
      reading.rig.extra_fields.push_back({reading.camera->name, name, entry.value.value});
    }
  }
}

/// True for topics that every YAML parser reads as a string even without quotes: a slash, then letters, digits, slashes and
/// underscores.
bool needs_no_quotes(std::string_view topic) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/_";
  return topic.starts_with('/') && topic.find_first_not_of(kPlain) == std::string_view::npos;
}

/// Writes the width or the height of the image [px].
std::vector<Statement> write_side(const Subject& subject, const Key& key, bool is_width) {
  const std::optional<ImageSize>& size = subject.the_camera().image_size;
  if (!size) return {};
  const int side = is_width ? size->width : size->height;
  const Fact fact = {.kind = FactKind::kImageSize, .row = is_width ? 0 : 1};
  return states(key.with.real ? fields::real(key.text(), side) : fields::integer(key.text(), side), fact);
}

/// Changes the sign, which converts a delay to a time offset and back. 0 stays 0 (not -0).
double negated(double seconds) { return seconds == 0.0 ? 0.0 : -seconds; }

/// The time offset [s] of the first camera that has one; nullopt if none has.
std::optional<double> common_offset(const Rig& rig) {
  const auto first = std::ranges::find_if(rig.cameras, [](const Camera& camera) { return camera.time_offset_s.has_value(); });
  return first == rig.cameras.end() ? std::nullopt : first->time_offset_s;
}

}  // namespace

/// Gives the camera the model of the lens with this name. Its parameters are read later, by another row.
bool read_lens_name(Reading& reading, const Key& key, const Node& node) {
  const auto lens = std::ranges::find(key.with.lenses, node.value, &Lens::name);
  if (lens == key.with.lenses.end()) {
    reading.reader.say(node, reading.schema.codes.unknown_model, {reading.camera->name, node.value.substr(0, kLongestQuote)});
    return false;
  }
  reading.camera->model = make_model(lens->model).value();
  reading.lens = lens->name;
  return true;
}

std::vector<Statement> write_lens_name(const Subject& subject, const Key& key) {
  return states(fields::quoted(key.text(), lens_name_of(subject.the_camera(), key)), {FactKind::kModel});
}

/// Reads one number for each parameter of the camera's model, which read_lens_name() must have set.
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

/// Writes the parameters of the camera's model and, if its lens has one, the additional key (Lens::further).
std::vector<Statement> write_parameters(const Subject& subject, const Key& key) {
  const CameraModel& model = subject.the_camera().model;
  std::vector<Statement> statements;
  for (const Parameter& parameter : model_info(model).parameters) {
    const double value = fca::parameter(model, ParameterId(parameter)).value();
    statements.push_back(
        {fields::real(std::string(parameter.name), value), {{.kind = FactKind::kParameter, .parameter = parameter.name}}});
  }
  const auto lens = std::ranges::find(key.with.lenses, model_info(model).id, &Lens::model);
  if (lens != key.with.lenses.end() && !lens->further.empty())
    statements.push_back({fields::real(std::string(lens->further), lens->none)});
  return statements;
}

bool read_parameter(Reading& reading, const Key& key, const Node& node) {
  return reading.reader.parameter(node, reading.owner, key.with.parameter.value(), reading.camera->model);
}

/// Writes nothing if the camera's model does not have the parameter.
std::vector<Statement> write_parameter(const Subject& subject, const Key& key) {
  const std::optional<double> value = fca::parameter(subject.the_camera().model, key.with.parameter.value());
  if (!value) return {};
  return states(fields::real(key.text(), *value), {.kind = FactKind::kParameter, .parameter = key.with.parameter->name()});
}

/// The camera keeps its default name if the value is empty or is no single value.
bool read_camera_name(Reading& reading, const Key& key, const Node& node) {
  if (std::string name = reading.reader.name(node, key.name); !name.empty()) reading.camera->name = std::move(name);
  return true;
}

/// Writes nothing in an edit, so that the file keeps its name for the camera.
std::vector<Statement> write_camera_name(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  return states(fields::quoted(key.text(), subject.the_camera().name));
}

/// Reads the width and the height of the image; the node is that of the height.
bool read_image_sides(Reading& reading, const Key& key, const Node& node) {
  const Node* width = reading.reader.find(*reading.mapping, key.with.other);
  if (width != nullptr) reading.camera->image_size = reading.reader.image_size(*width, node, reading.owner + " ");
  return reading.camera->image_size.has_value();
}

std::vector<Statement> write_image_width(const Subject& subject, const Key& key) { return write_side(subject, key, true); }

std::vector<Statement> write_image_height(const Subject& subject, const Key& key) { return write_side(subject, key, false); }

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
  std::optional<double>& offset = reading.camera->time_offset_s;
  offset = reading.reader.time_offset(node, reading.label(key));
  return offset.has_value();
}

std::vector<Statement> write_time_offset(const Subject& subject, const Key& key) {
  const std::optional<double>& offset = subject.the_camera().time_offset_s;
  if (!offset) return {};
  return states(fields::real(key.text(), *offset), {FactKind::kTimeOffset});
}

bool read_topic(Reading& reading, const Key& key, const Node& node) {
  std::string& topic = key.with.of_imu ? reading.imu->topic : reading.camera->topic;
  topic = reading.reader.name(node, reading.label(key));
  return true;
}

std::vector<Statement> write_topic(const Subject& subject, const Key& key) {
  const std::string& topic = key.with.of_imu ? subject.rig.imus[subject.imu].topic : subject.the_camera().topic;
  if (topic.empty()) return {};
  const bool quoted = key.with.of_imu || !needs_no_quotes(topic);
  return states(quoted ? fields::quoted(key.text(), topic) : fields::scalar(key.text(), topic), {FactKind::kTopic});
}

/// Gives all cameras the file's time offset, which must be a whole number of the file's unit.
bool read_common_offset(Reading& reading, const Key& key, const Node& node) {
  const std::optional<double> offset = reading.reader.real(node, key.name);
  if (!offset) return false;
  if (*offset != std::floor(*offset)) {
    reading.reader.say(node, reading.schema.codes.offset_not_whole, {key.name, node.value});
    return false;
  }
  const double seconds = *offset / key.with.per_second;
  if (const Message problem = problem_with_time_offset(seconds); problem.is_said()) {
    reading.reader.say(node, reading.schema.codes.offset_invalid, {key.name, problem});
    return false;
  }
  for (Camera& camera : reading.rig.cameras) camera.time_offset_s = seconds;
  return true;
}

/// Writes the time offset of the first camera that has one, rounded to the file's unit; 0 if no camera has one.
std::vector<Statement> write_common_offset(const Subject& subject, const Key& key) {
  const long long offset = std::llround(common_offset(subject.rig).value_or(0.0) * key.with.per_second);
  return states(fields::scalar(key.text(), std::to_string(offset)), {FactKind::kTimeOffset});
}

/// Gives all cameras the negative delay as their time offset.
bool read_common_delay(Reading& reading, const Key& key, const Node& node) {
  const std::optional<double> delay = reading.reader.time_offset(node, reading.label(key));
  if (!delay) return false;
  for (Camera& camera : reading.rig.cameras) camera.time_offset_s = negated(*delay);
  return true;
}

/// Writes nothing in an edit if the rig has no time offset, so that the file keeps its delay.
std::vector<Statement> write_common_delay(const Subject& subject, const Key& key) {
  const std::optional<double> offset = common_offset(subject.rig);
  if (!offset && subject.fresh == nullptr) return {};
  return states(fields::real(key.text(), negated(offset.value_or(0.0))), {FactKind::kTimeOffset});
}

}  // namespace fca::schema
