// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_copies.h"

#include "refusal.h"

#include <fca/code.h>
#include <fca/formats/text/limits.h>
#include <fca/formats/text/source.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fca::text {

namespace {

bool is_merge(const Entry& entry) { return entry.key.value == "<<" && !entry.key.quoted && entry.key.tag.empty(); }

}  // namespace

void YamlCopies::keep(std::size_t anchor, const Node& node) {
  count(anchored_.insert_or_assign(anchor, node).first->second, false, node.span.offset);
}

std::optional<Node> YamlCopies::copy(std::size_t anchor, std::size_t at) {
  const auto found = anchored_.find(anchor);
  return found != anchored_.end() ? std::optional(copy_of(found->second, at)) : std::nullopt;
}

void YamlCopies::merge(Node& mapping) {
  if (std::ranges::none_of(mapping.entries, is_merge)) return;
  std::vector<Entry> merged;
  std::vector<Entry> own;
  for (Entry& entry : mapping.entries) (is_merge(entry) ? merged : own).push_back(std::move(entry));
  mapping.entries = std::move(own);
  std::set<std::string> keys;
  for (const Entry& entry : mapping.entries) keys.insert(entry.key.value);
  const auto add = [&](const Node& from, std::size_t at) {
    if (!from.is_mapping()) throw Refusal{{Code::kYamlMergeKey}, at};
    for (const Entry& entry : from.entries) {
      if (keys.insert(entry.key.value).second) mapping.entries.push_back({entry.key, copy_of(entry.value, at)});
    }
  };
  std::ranges::reverse(merged);
  for (const Entry& entry : merged) {
    const std::size_t at = entry.key.span.offset;
    if (!entry.value.is_sequence()) add(entry.value, at);
    for (const Node& item : entry.value.items) add(item, at);
  }
}

void YamlCopies::count(Node& node, bool marks, std::size_t at) {
  bytes_ += node.value.size();
  if (++nodes_ > kLongestList || bytes_ > kMaxFileBytes) throw too_long(at);
  node.copied = node.copied || marks;
  for (Node& item : node.items) count(item, marks, at);
  for (Entry& entry : node.entries) count(entry.value, marks, at);
}

Node YamlCopies::copy_of(const Node& node, std::size_t at) {
  if (!first_) first_ = at;
  Node copy = node;
  count(copy, true, at);
  return copy;
}

}  // namespace fca::text
