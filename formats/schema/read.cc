// SPDX-License-Identifier: BSD-3-Clause
// Reads a rig from a document: walks the table and lets each row read its node.
#include "keys.h"
#include "schema.h"

#include <fca/code.h>

#include <algorithm>

namespace fca::schema {

using text::Node;

namespace {

/// Adds one warning that names all missing keys which only the program requires.
void warn_of_missing(Reading& reading, const Mapping& mapping, const Node& node) {
  if (mapping.missing == Code{}) return;
  std::vector<std::string> missing;
  for (const Key* key : in_written_order(mapping)) {
    if (key->need != Need::kRequired && reading.reader.find(node, key->name) == nullptr) missing.emplace_back(key->name);
  }
  SourceRange where = reading.reader.document().range(node);
  where.length = 1;
  if (!missing.empty()) reading.reader.diagnostics().add(mapping.missing, {missing, reading.schema.program}, where);
}

/// A row that is a list with one item for each camera, and its node.
struct CameraList {
  const Key* key;
  const Node* node;
};

/// True if the list has `count` items, or may have another number of items (kSomeEach). Otherwise false, with an error.
bool has_items(Reading& reading, const CameraList& list, std::size_t count) {
  if (list.node->is_sequence() && (list.key->spread == Spread::kSomeEach || list.node->items.size() == count)) return true;
  if (list.key->spread == Spread::kSomeEach) return true;
  if (list.node->is_sequence()) {
    reading.reader.say(*list.node, reading.schema.codes.item_count, {list.key->name, list.node->items.size(), count});
  } else {
    reading.reader.say(*list.node, reading.schema.codes.no_list, {list.key->name, count});
  }
  return false;
}

/// Collects in `lists` the lists of the mapping with items of cameras, and sets `count` to the number of cameras. False, with
/// errors, if the list that determines this number (kCounted) is missing or another list cannot be read.
bool find_lists(Reading& reading, const Mapping& mapping, const Node& node, std::vector<CameraList>& lists,
                std::size_t& count) {
  bool good = true;
  for (const Key& key : mapping.keys) {
    if (key.spread == Spread::kOnce) continue;
    const CameraList list = {&key, find_value(reading, key, node)};
    if (key.spread == Spread::kCounted) {
      if (list.node == nullptr) return false;
      if (!list.node->is_sequence() || list.node->items.empty()) {
        reading.reader.say(*list.node, reading.schema.codes.no_camera_list, {key.name});
        return false;
      }
      count = list.node->items.size();
    } else if (list.node == nullptr) {
      continue;
    } else if (!has_items(reading, list, count)) {
      good = false;
      continue;
    }
    lists.push_back(list);
  }
  return good;
}

/// Adds to the rig the cameras for which the mapping has lists, and reads the items of each camera. False, with errors, if one
/// cannot be read.
bool read_cameras(Reading& reading, const Mapping& mapping, const Node& node) {
  std::vector<CameraList> lists;
  std::size_t count = 0;
  bool good = find_lists(reading, mapping, node, lists, count);
  if (lists.empty()) return good;
  for (std::size_t i = 0; i < count; ++i) {
    Camera& camera = reading.rig.cameras.emplace_back();
    camera.name = "cam" + std::to_string(i);
    camera.image_size = reading.options.image_size;
    Reading item = reading;
    item.owner = camera.name;
    item.camera = &camera;
    for (const CameraList& list : lists) {
      if (i < list.node->items.size()) good = list.key->read(item, *list.key, list.node->items[i]) && good;
    }
  }
  return good;
}

}  // namespace

void keep_unread(Reading& reading, const Mapping& mapping, const Node& node, const std::string& owner) {
  for (const text::Entry& entry : node.entries) {
    const auto row = std::ranges::find(mapping.keys, entry.key.value, &Key::name);
    if (!mapping.unread || (row != mapping.keys.end() && !row->with.only_warns)) continue;
    if (mapping.warns_of_duplicates && text::find(node, entry.key.value, reading.schema.dialect) != &entry.value) continue;
    reading.rig.extra_fields.push_back(
        {owner, std::string(*mapping.unread) + entry.key.value, fields::value_text(entry.value)});
  }
  for (const Key& key : mapping.keys) {
    const bool has_mapping = key.with.mapping != nullptr && key.spread == Spread::kOnce;
    const Node* value = has_mapping ? text::find(node, key.name, reading.schema.dialect) : nullptr;
    if (value != nullptr) keep_unread(reading, *key.with.mapping, *value, owner);
  }
}

std::vector<const Key*> in_written_order(const Mapping& mapping) {
  std::vector<const Key*> keys;
  for (const std::string_view name : mapping.written) keys.push_back(&*std::ranges::find(mapping.keys, name, &Key::name));
  for (const Key& key : mapping.keys) {
    if (std::ranges::find(mapping.written, key.name) == mapping.written.end()) keys.push_back(&key);
  }
  return keys;
}

const Node* find_value(Reading& reading, const Key& key, const Node& mapping) {
  const Codes& codes = reading.schema.codes;
  if (key.need == Need::kRequired && codes.missing == Code{})
    return reading.reader.require(mapping, key.name, reading.owner.empty() ? reading.schema.what : reading.owner);
  const Node* node = reading.reader.find(mapping, key.name);
  const bool needs_mapping = key.with.mapping != nullptr || key.inside;
  const bool is_no_mapping = node != nullptr && codes.wrong != Code{} && needs_mapping && !node->is_mapping();
  if (!is_no_mapping && (node != nullptr || key.need == Need::kOptional)) return node;
  const bool is_error = key.need == Need::kRequired;
  const bool is_top_level = reading.owner.empty();
  std::vector<Argument> arguments = {key.name, is_error ? std::vector<Message>() : std::vector<Message>{{codes.unless_wanted}}};
  if (!is_top_level) arguments.insert(arguments.begin(), reading.owner);
  SourceRange where = reading.reader.document().range(is_no_mapping ? *node : mapping);
  where.length = 1;
  reading.reader.diagnostics().add(is_error ? Severity::kError : Severity::kWarning,
                                   is_no_mapping  ? codes.wrong
                                   : is_top_level ? codes.missing
                                                  : codes.missing_below,
                                   arguments, where);
  return nullptr;
}

bool read_mapping(Reading& reading, const Mapping& mapping, const Node& node) {
  if (mapping.warns_of_duplicates) reading.reader.warn_of_duplicates(node);
  warn_of_missing(reading, mapping, node);
  bool good = read_cameras(reading, mapping, node);
  reading.mapping = &node;
  for (const Key& key : mapping.keys) {
    if (key.spread != Spread::kOnce) continue;
    const Node* value = find_value(reading, key, node);
    const bool read = value != nullptr ? key.read == nullptr || key.read(reading, key, *value) : key.need != Need::kRequired;
    good = good && read;
    if (!read && mapping.stops_at_error) return false;
  }
  return good;
}

bool read_object(Reading& reading, const Key& key, const Node& node) {
  Reading inside = reading;
  if (key.spread == Spread::kOnce) inside.owner = reading.label(key);
  if (node.is_mapping()) return read_mapping(inside, *key.with.mapping, node);
  reading.reader.say(node, reading.schema.codes.no_object, {inside.owner});
  return false;
}

std::optional<Rig> read(const Schema& schema, std::span<const text::Document> documents, const ReadOptions& options,
                        Diagnostics& diagnostics) {
  if (documents.size() != 1 || !documents.front().root().is_mapping()) {
    diagnostics.add(schema.codes.wrong_syntax, {}, {documents.empty() ? "" : documents.front().source().name, 0, 0});
    return std::nullopt;
  }
  Rig rig;
  fields::Reader reader(documents.front(), schema.dialect, diagnostics);
  Reading reading{schema, reader, options, rig, ""};
  if (schema.one_camera) {
    reading.camera = &rig.cameras.emplace_back();
    reading.camera->name = "cam0";
    if (const std::optional<CameraModel> model = make_model(schema.model)) reading.camera->model = *model;
  }
  if (!read_mapping(reading, schema.root, documents.front().root())) return std::nullopt;
  keep_unread(reading, schema.root, documents.front().root(), "");
  reader.warn_of_misspelt();
  return rig;
}

}  // namespace fca::schema
