// SPDX-License-Identifier: BSD-3-Clause
// From documents to rigs: walks the table and lets each row read its node.
#include "keys.h"
#include "schema.h"

#include <fca/code.h>

#include <algorithm>
#include <set>

namespace fca::schema {

using text::Node;

namespace {

/// Keys that only the program demands, all in one warning.
void warn_of_missing(Reading& reading, const Mapping& mapping, const Node& node) {
  if (mapping.missing == Code{}) return;
  std::vector<std::string> missing;
  for (const Key* key : in_written_order(mapping)) {
    if (!key->required && reading.reader.find(node, key->name) == nullptr) missing.emplace_back(key->name);
  }
  SourceRange where = reading.reader.document().range(node);
  where.length = 1;
  if (!missing.empty()) reading.reader.diagnostics().add(mapping.missing, {missing}, where);
}

const Node* find(Reading& reading, const Key& key, const Node& node) {
  if (!key.required) return reading.reader.find(node, key.name);
  return reading.reader.require(node, key.name, reading.owner.empty() ? reading.schema.what : reading.owner);
}

/// A list with one item for each camera.
struct CameraList {
  const Key* key;
  const Node* node;
};

/// False with an error where the list has not that many items.
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

/// The lists of the mapping that can be read; `count` is that of the cameras. False with errors where one cannot.
bool find_lists(Reading& reading, const Mapping& mapping, const Node& node, std::vector<CameraList>& lists,
                std::size_t& count) {
  bool good = true;
  for (const Key& key : mapping.keys) {
    if (key.spread == Spread::kOnce) continue;
    const CameraList list = {&key, find(reading, key, node)};
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

/// Camera by camera.
bool read_cameras(Reading& reading, const Mapping& mapping, const Node& node) {
  std::vector<CameraList> lists;
  std::size_t count = 0;
  bool good = find_lists(reading, mapping, node, lists, count);
  if (lists.empty()) return good;
  for (std::size_t i = 0; i < count; ++i) {
    Camera& camera = reading.rig.cameras.emplace_back();
    camera.name = "cam" + std::to_string(i);
    camera.image_size = reading.options.image_size;
    Reading item{reading.schema, reading.reader, reading.options, reading.rig, camera.name, &camera};
    for (const CameraList& list : lists) {
      if (i < list.node->items.size()) good = list.key->read(item, *list.key, list.node->items[i]) && good;
    }
  }
  return good;
}

void keep_unread(Reading& reading, const Mapping& mapping, const Node& node) {
  for (const text::Entry& entry : node.entries) {
    if (std::ranges::find(mapping.keys, entry.key.value, &Key::name) != mapping.keys.end()) continue;
    if (reading.reader.find(node, entry.key.value) == &entry.value)
      reading.rig.extra_fields.push_back({"", entry.key.value, fields::value_text(entry.value)});
  }
}

}  // namespace

std::vector<const Key*> in_written_order(const Mapping& mapping) {
  std::vector<const Key*> keys;
  for (const Key& key : mapping.keys) keys.push_back(&key);
  const auto place = [&mapping](const Key* key) {
    return std::ranges::find(mapping.written, key->name) - mapping.written.begin();
  };
  if (!mapping.written.empty()) std::ranges::stable_sort(keys, {}, place);
  return keys;
}

bool read_mapping(Reading& reading, const Mapping& mapping, const Node& node) {
  if (mapping.keeps_unread) reading.reader.warn_of_duplicates(node);
  warn_of_missing(reading, mapping, node);
  bool good = read_cameras(reading, mapping, node);
  for (const Key& key : mapping.keys) {
    if (key.spread != Spread::kOnce) continue;
    const Node* value = find(reading, key, node);
    if (value != nullptr) good = key.read(reading, key, *value) && good;
    if (value == nullptr && key.required) good = false;
  }
  if (mapping.keeps_unread) keep_unread(reading, mapping, node);
  return good;
}

bool read_object(Reading& reading, const Key& key, const Node& node) {
  Reading inside = reading;
  if (key.spread == Spread::kOnce) inside.owner = reading.label(key);
  if (node.is_mapping()) return read_mapping(inside, *key.mapping, node);
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
  if (!read_mapping(reading, schema.root, documents.front().root())) return std::nullopt;
  reader.warn_of_misspelt();
  return rig;
}

}  // namespace fca::schema
