// SPDX-License-Identifier: BSD-3-Clause
// Where a document states a fact.
#include "schema.h"

#include <algorithm>

namespace fca::schema {

using text::Node;

namespace {

/// A quaternion states every element of its rotation.
bool states(const Fact& stated, const Fact& wanted) {
  return stated == wanted ||
         (stated.kind == FactKind::kPose && wanted.kind == FactKind::kPose && stated.row < 0 && wanted.column < 3);
}

/// The token's node: of a scalar itself, of a list its item.
const Node* token_of(const Node& value, std::size_t index) {
  if (!value.is_sequence()) return index == 0 ? &value : nullptr;
  return index < value.items.size() ? &value.items[index] : nullptr;
}

const Node* find_token(const Statement& statement, const Node* value, const Fact& fact) {
  for (std::size_t i = 0; value != nullptr && i < statement.facts.size(); ++i) {
    if (states(statement.facts[i], fact)) return token_of(*value, i);
  }
  return nullptr;
}

const Node* find_in(const Mapping& mapping, const Node& node, const Subject& subject, const Fact& fact);

/// In the value of a key; of a list with items for the cameras, in that camera's.
const Node* find_below(const Key& key, const Node& value, const Subject& subject, const Fact& fact) {
  const Node* item = key.spread == Spread::kOnce ? &value : token_of(value, subject.camera);
  if (item == nullptr) return nullptr;
  if (key.mapping != nullptr) return find_in(*key.mapping, *item, subject, fact);
  if (key.write == nullptr || key.fact != fact.kind) return nullptr;
  for (const Statement& statement : key.write(subject, key)) {
    const Node* stated = key.inside ? text::find(*item, statement.field.key, subject.schema.dialect) : item;
    if (const Node* found = find_token(statement, stated, fact)) return found;
  }
  return nullptr;
}

const Node* find_in(const Mapping& mapping, const Node& node, const Subject& subject, const Fact& fact) {
  for (const Key& key : mapping.keys) {
    const Node* value = text::find(node, key.name, subject.schema.dialect);
    const Node* found = value != nullptr ? find_below(key, *value, subject, fact) : nullptr;
    if (found != nullptr) return found;
  }
  return nullptr;
}

}  // namespace

const Node* place_of(const Schema& schema, const text::Document& document, const Rig& rig, std::size_t camera,
                     const Fact& fact) {
  return find_in(schema.root, document.root(), {schema, rig, camera}, fact);
}

}  // namespace fca::schema
