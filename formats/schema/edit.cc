// SPDX-License-Identifier: BSD-3-Clause
// Edits a document that contains the rig `before` so that it contains the rig `after`.
#include "schema.h"

#include <algorithm>
#include <iterator>

namespace fca::schema {

using fields::Field;
using text::Node;

namespace {

class Editor {
 public:
  Editor(text::Document& document, Written& written) : document_(document), written_(written) {}

  /// Edits the values of a mapping and of the mappings in it.
  void edit(const Mapping& mapping, const Node& node, const Subject& before, const Subject& after) {
    std::vector<Field> from;
    std::vector<Field> to;
    for (const Key* key : in_written_order(mapping)) {
      if (key->spread == Spread::kOnce && key->with.mapping == nullptr && !key->inside) {
        add_fields(*key, before, after, from, to);
      } else if (const Node* value = text::find(node, key->name, after.schema.dialect)) {
        edit_below(*key, *value, before, after);
      }
    }
    fields::apply(document_, node, after.schema.dialect, from, to);
  }

 private:
  /// Adds the fields of a row before the edit to `from`, and those after it to `to`. If the new rig does not have the fact,
  /// both are the old fields, so that the file does not change.
  static void add_fields(const Key& key, const Subject& before, const Subject& after, std::vector<Field>& from,
                         std::vector<Field>& to) {
    if (key.write == nullptr) return;
    std::vector<Field> old = fields_of(key.write(before, key));
    std::vector<Field> now = fields_of(key.write(after, key));
    if (now.empty()) now = old;
    std::ranges::move(old, std::back_inserter(from));
    std::ranges::move(now, std::back_inserter(to));
  }

  /// Edits the value of a key: an object, or a list with one item for each camera.
  void edit_below(const Key& key, const Node& value, const Subject& before, const Subject& after) {
    if (key.spread == Spread::kOnce) return edit_value(key, value, before, after);
    for (std::size_t i = 0; i < std::min(value.items.size(), after.rig.cameras.size()); ++i)
      edit_value(key, value.items[i], {before.schema, before.rig, i}, {after.schema, after.rig, i});
  }

  /// Edits the value of a key, or one item of its list.
  void edit_value(const Key& key, const Node& value, const Subject& before, const Subject& after) {
    if (key.with.mapping != nullptr) return edit(*key.with.mapping, value, before, after);
    if (key.edit != nullptr) return key.edit(document_, value, key, before, after, written_);
    if (key.write == nullptr) return;
    const std::vector<Field> from = fields_of(key.write(before, key));
    const std::vector<Field> to = fields_of(key.write(after, key));
    if (key.inside) return fields::apply(document_, value, after.schema.dialect, from, to);
    if (!to.empty() && from != to) edit_items(value, to.front());
  }

  /// Replaces the numbers of a list by the tokens of `field`.
  void edit_items(const Node& list, const Field& field) {
    for (std::size_t i = 0; i < std::min(list.items.size(), field.tokens.size()); ++i)
      fields::set_scalar(document_, list.items[i], field.tokens[i]);
  }

  text::Document& document_;
  Written& written_;
};

}  // namespace

std::vector<Field> fields_of(std::vector<Statement> statements) {
  std::vector<Field> fields;
  fields.reserve(statements.size());
  for (Statement& statement : statements) fields.push_back(std::move(statement.field));
  return fields;
}

std::vector<Field> sorted_fields(const Subject& subject, const Mapping& mapping, FactKind but) {
  std::vector<Field> fields;
  for (const Key& key : mapping.keys) {
    if (key.write == nullptr || key.fact == but) continue;
    std::ranges::move(fields_of(key.write(subject, key)), std::back_inserter(fields));
  }
  std::ranges::sort(fields, {}, &Field::key);
  return fields;
}

bool same_cameras(const Rig& old, const Rig& rig) {
  return std::ranges::equal(old.cameras, rig.cameras, {}, &Camera::name, &Camera::name);
}

text::Document edited(const text::Document& base, const Subject& before, const Subject& after, Written& written) {
  text::Document document = base;
  edit(document, after.schema.root, document.root(), before, after, written);
  return document;
}

void edit(text::Document& document, const Mapping& mapping, const Node& node, const Subject& before, const Subject& after,
          Written& written) {
  Editor(document, written).edit(mapping, node, before, after);
}

}  // namespace fca::schema
