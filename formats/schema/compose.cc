// SPDX-License-Identifier: BSD-3-Clause
// Composes the text of a fresh file from a rig.
#include "../composed.h"
#include "../spelling.h"
#include "schema.h"

namespace fca::schema {

namespace {

constexpr std::size_t kIndent = 2;  ///< The number of additional blanks before the lines of each deeper level.
constexpr text::Syntax kJson = text::Syntax::kJson;

std::string blanks(std::size_t count) { return std::string().append(count, ' '); }

/// A line of an object: a key and the text of its value.
std::string entry(std::string_view name, std::size_t depth, const std::string& value) {
  return blanks(depth) + "\"" + std::string(name) + "\": " + value;
}

/// Values between brackets. Without `depth`, all are on one line. With it, each value is on a line of its own and the closing
/// bracket is indented by `depth` blanks.
std::string enclosed(const std::vector<std::string>& values, char open, char close, std::optional<std::size_t> depth) {
  std::string text(1, open);
  std::string separator = depth ? "\n" : "";
  for (const std::string& value : values) {
    text += separator + value;
    separator = depth ? ",\n" : ", ";
  }
  return text + (depth ? "\n" + blanks(*depth) : "") + close;
}

/// The key and the value of each statement of a row, indented by `depth` blanks.
std::vector<std::string> lines_of(const Subject& subject, const Key& key, std::size_t depth) {
  std::vector<std::string> lines;
  for (const Statement& statement : key.write(subject, key)) {
    const fields::Field& field = statement.field;
    if (subject.schema.numbers_in_lines && field.shape == fields::Shape::kList) {
      std::vector<std::string> numbers;
      for (const std::string& token : field.tokens) numbers.push_back(blanks(depth + kIndent) + token);
      lines.push_back(entry(field.key, depth, enclosed(numbers, '[', ']', depth)));
    } else {
      lines.push_back(fields::spell(field, depth, kJson));
    }
  }
  return lines;
}

/// The texts of the keys and values of an object, indented by `depth` blanks.
std::vector<std::string> members(const Subject& subject, const Mapping& mapping, std::size_t depth);

/// The text of an object, whose closing bracket is indented by `depth` blanks.
std::string object(const Subject& subject, const Key& key, std::size_t depth) {
  const std::size_t below = depth + kIndent;
  const std::vector<std::string> lines =
      key.with.mapping != nullptr ? members(subject, *key.with.mapping, below) : lines_of(subject, key, below);
  return enclosed(lines, '{', '}', depth);
}

/// True if the value of the key is an object.
bool is_object(const Key& key) { return key.with.mapping != nullptr || key.inside; }

/// The text of a list with one item for each camera. A list that may have fewer items (kSomeEach) is written empty.
std::string list(const Subject& subject, const Key& key, std::size_t depth) {
  std::vector<std::string> items;
  for (std::size_t i = 0; key.spread != Spread::kSomeEach && i < subject.rig.cameras.size(); ++i) {
    Subject item = subject;
    item.camera = i;
    if (is_object(key)) {
      items.push_back(blanks(depth + kIndent) + object(item, key, depth + kIndent));
    } else {
      items.push_back(fields::spell_value(key.write(item, key).front().field, kJson, {}));
    }
  }
  return enclosed(items, '[', ']', is_object(key) ? std::optional(depth) : std::nullopt);
}

std::vector<std::string> members(const Subject& subject, const Mapping& mapping, std::size_t depth) {
  std::vector<std::string> lines;
  for (const Key* key : in_written_order(mapping)) {
    if (key->spread != Spread::kOnce) {
      lines.push_back(entry(key->name, depth, list(subject, *key, depth)));
    } else if (is_object(*key)) {
      lines.push_back(entry(key->name, depth, object(subject, *key, depth)));
    } else if (key->write != nullptr) {
      for (const std::string& line : lines_of(subject, *key, depth)) lines.push_back(line);
    }
  }
  return lines;
}

}  // namespace

std::optional<text::Document> composed_yaml(const Subject& subject, std::string head, std::string name,
                                            Diagnostics& diagnostics) {
  ComposedYaml file(std::move(head));
  for (const Key* key : in_written_order(subject.schema.root)) {
    if (key->with.only_edited) continue;
    if (key->with.mapping == nullptr) {
      if (key->write == nullptr) continue;
      for (const fields::Field& field : fields_of(key->write(subject, *key))) file.add(field);
      continue;
    }
    std::vector<fields::Field> inside;
    for (const Key* below : in_written_order(*key->with.mapping)) {
      if (below->write == nullptr) continue;
      for (fields::Field& field : fields_of(below->write(subject, *below))) inside.push_back(std::move(field));
    }
    if (!inside.empty()) file.add_mapping(key->text(), inside, kIndent);
  }
  return std::move(file).document(std::move(name), diagnostics);
}

std::string yaml_lines(const Subject& subject, const Mapping& mapping, std::size_t depth, std::size_t deeper) {
  std::string text;
  for (const Key* key : in_written_order(mapping)) {
    if (key->with.only_edited) continue;
    if (key->with.mapping != nullptr) {
      text += blanks(depth) + key->text() + ":\n" + yaml_lines(subject, *key->with.mapping, depth + deeper, deeper);
    } else if (key->write != nullptr) {
      for (const fields::Field& field : fields_of(key->write(subject, *key))) text += fields::spell(field, depth) + "\n";
    }
  }
  return text;
}

std::string composed_json(const Schema& schema, const Rig& rig, std::size_t camera, Written& written) {
  const Subject subject{.schema = schema, .rig = rig, .camera = camera, .fresh = &written};
  return enclosed(members(subject, schema.root, kIndent), '{', '}', 0) + "\n";
}

}  // namespace fca::schema
