// SPDX-License-Identifier: BSD-3-Clause
// Finds the node of a document that contains a fact.
#include "schema.h"

#include <algorithm>

namespace fca::schema {

using text::Node;

namespace {

/// True if a number in the file whose fact is `in_file` contains the fact `wanted`. A number of a quaternion (row -1) contains
/// every element of the rotation.
bool contains(const Fact& in_file, const Fact& wanted) {
  return in_file == wanted || (in_file.kind == FactKind::kPose && wanted.kind == FactKind::kPose && in_file.row < 0 &&
                               in_file.pose == wanted.pose && wanted.column < 3);
}

/// Collects the scalars of a value, which may be a list or a list of rows, in the order of the file.
void collect_tokens(const Node& value, std::vector<const Node*>& tokens) {
  if (value.is_scalar()) tokens.push_back(&value);
  for (const Node& item : value.items) collect_tokens(item, tokens);
}

/// The scalar of a statement's value that contains the fact; null if there is none.
const Node* find_token(const Statement& statement, const Node* value, const Fact& fact) {
  const auto found = std::ranges::find_if(statement.facts, [&fact](const Fact& each) { return contains(each, fact); });
  if (value == nullptr || found == statement.facts.end()) return nullptr;
  std::vector<const Node*> tokens;
  collect_tokens(*value, tokens);
  const auto index = static_cast<std::size_t>(found - statement.facts.begin());
  return index < tokens.size() ? tokens[index] : nullptr;
}

/// The node in a mapping of the file that contains the fact; null if there is none.
const Node* find_in(const Mapping& mapping, const Node& node, const Subject& subject, const Fact& fact);

/// The key of a row in the file: its name or, for kNamed and kNamedImu, the name of the camera or of the IMU.
std::string_view name_of(const Key& key, const Subject& subject) {
  const bool of_camera = key.spread == Spread::kNamed && subject.camera < subject.rig.cameras.size();
  const bool of_imu = key.spread == Spread::kNamedImu && subject.imu < subject.rig.imus.size();
  return of_camera ? subject.the_camera().name : of_imu ? subject.rig.imus[subject.imu].name : key.name;
}

/// True if the value of the key is a list of items of cameras.
bool is_list(const Key& key) {
  return key.spread == Spread::kCounted || key.spread == Spread::kEach || key.spread == Spread::kSomeEach;
}

/// The node that contains the fact in the value of a key or, if the value is a list of items of cameras, in the camera's item.
/// Null if there is none.
const Node* find_below(const Key& key, const Node& value, const Subject& subject, const Fact& fact) {
  if (is_list(key) && (!value.is_sequence() || subject.camera >= value.items.size())) return nullptr;
  const Node* item = is_list(key) ? &value.items[subject.camera] : &value;
  if (key.with.mapping != nullptr) return find_in(*key.with.mapping, *item, subject, fact);
  if (key.write == nullptr || key.fact != fact.kind) return nullptr;
  for (const Statement& statement : key.write(subject, key)) {
    const Node* tokens = key.inside ? text::find(*item, statement.field.key, subject.schema.dialect) : item;
    if (const Node* found = find_token(statement, tokens, fact)) return found;
  }
  return nullptr;
}

const Node* find_in(const Mapping& mapping, const Node& node, const Subject& subject, const Fact& fact) {
  for (const Key& key : mapping.keys) {
    const Node* value = text::find(node, name_of(key, subject), subject.schema.dialect);
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
