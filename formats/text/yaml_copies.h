// SPDX-License-Identifier: BSD-3-Clause
// What aliases (*name) and merge keys (<<) of YAML copy, in PyYAML's order. Copies of copies could fill any memory: all
// together are no more than the longest list (limits.h), and no longer than the largest file.
#pragma once

#include <fca/formats/text/node.h>

#include <cstddef>
#include <map>
#include <optional>

namespace fca::text {

class YamlCopies {
 public:
  /// Keeps what is anchored, for later aliases. Throws a Refusal where that is too much, as copy() and merge() do.
  void keep(std::size_t anchor, const Node& node);
  /// What is anchored, marked as copied; nothing of an anchor that is unknown or still open. `at`: the alias.
  [[nodiscard]] std::optional<Node> copy(std::size_t anchor, std::size_t at);
  /// Replaces the mapping's merge keys by the entries that they add: those of a mapping, or of the mappings of a list, whose
  /// keys are not there. Of several merge keys the last one comes first, of a list the first mapping.
  void merge(Node& mapping);

  /// Where the first alias or merge key is.
  [[nodiscard]] std::optional<std::size_t> first() const { return first_; }

 private:
  /// Counts all nodes of what is a copy or becomes one. `marks`: says so in them, too.
  void count(Node& node, bool marks, std::size_t at);
  [[nodiscard]] Node copy_of(const Node& node, std::size_t at);

  std::map<std::size_t, Node> anchored_;
  std::size_t nodes_ = 0;
  std::size_t bytes_ = 0;
  std::optional<std::size_t> first_;
};

}  // namespace fca::text
