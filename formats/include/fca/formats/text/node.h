// SPDX-License-Identifier: BSD-3-Clause
// The same tree for every syntax: values keep their raw spelling and their place.
#pragma once

#include <fca/formats/text/source.h>

#include <string>
#include <string_view>
#include <vector>

namespace fca::text {

/// Nesting deeper than this is an attack, not a calibration.
inline constexpr int kMaxDepth = 64;

enum class NodeKind { kNull, kScalar, kSequence, kMapping };

struct Entry;

/// A value of a document. What its spelling means is asked with a Dialect (dialect.h).
struct Node {
  NodeKind kind = NodeKind::kNull;
  Span span;                   ///< Scalars with their quotes; flow collections with their brackets; block collections from the
                               ///< first key or dash to the end of the last value. Empty for a missing value.
  std::string value;           ///< Scalars: the text with quotes and escapes resolved.
  bool quoted = false;         ///< Scalars: '..' or "..".
  bool flow = false;           ///< Collections: [..] or {..}.
  bool copied = false;         ///< By an alias or a merge key of YAML: its text stands elsewhere, and cannot be edited here.
  std::string tag;             ///< "" or as written, e.g. "tag:yaml.org,2002:opencv-matrix".
  std::vector<Node> items;     ///< Sequences.
  std::vector<Entry> entries;  ///< Mappings: in file order, duplicates included.

  [[nodiscard]] bool is_scalar() const { return kind == NodeKind::kScalar; }
  [[nodiscard]] bool is_sequence() const { return kind == NodeKind::kSequence; }
  [[nodiscard]] bool is_mapping() const { return kind == NodeKind::kMapping; }
};

/// A key with its value.
struct Entry {
  Node key;
  Node value;
};

/// The first copied value of a tree; null if there is none.
[[nodiscard]] const Node* first_copy(const Node& root);

}  // namespace fca::text
