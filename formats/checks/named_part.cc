// SPDX-License-Identifier: BSD-3-Clause
#include "named_part.h"

#include <fca/formats/text/dialect.h>
#include <fca/formats/text/read_document.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca::checks {

namespace {

using text::Node;

/// The value under a path of keys separated by '/' or '.'; keys may themselves hold points.
const Node* find_path(const Node& mapping, std::string_view path) {
  if (const text::Entry* entry = text::find_entry(mapping, path, text::Dialect::kOpenCv))
    return entry->value.span.length > 0 ? &entry->value : &entry->key;
  for (std::size_t at = path.find_first_of("/."); at != std::string_view::npos; at = path.find_first_of("/.", at + 1)) {
    const text::Entry* owner = text::find_entry(mapping, path.substr(0, at), text::Dialect::kOpenCv);
    if (owner == nullptr) continue;
    if (owner->value.is_mapping()) {
      if (const Node* found = find_path(owner->value, path.substr(at + 1))) return found;
    }
    return &owner->key;  // the key itself is missing there
  }
  return nullptr;
}

/// The list whose item begins there, and which.
struct Item {
  const Node* list = nullptr;
  std::size_t index = 0;
};

std::optional<Item> item_at(const Node& node, std::size_t offset) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (node.items[i].is_scalar() && node.items[i].span.offset == offset) return Item{&node, i};
    if (std::optional<Item> found = item_at(node.items[i], offset)) return found;
  }
  for (const text::Entry& entry : node.entries) {
    if (std::optional<Item> found = item_at(entry.value, offset)) return found;
  }
  return std::nullopt;
}

}  // namespace

const Node* exchanged_with(const text::Document& document, const Format& format, const ReadOptions& options,
                           std::size_t offset) {
  const std::optional<Item> item = item_at(document.root(), offset);
  if (!item) return nullptr;
  const std::vector<Node>& items = item->list->items;
  for (const std::size_t other : {item->index + 1, item->index - 1}) {
    if (other >= items.size()) continue;  // 0 - 1 is large
    text::Document exchanged = document;
    exchanged.replace(items[item->index].span, std::string(document.source().text(items[other].span)));
    exchanged.replace(items[other].span, std::string(document.source().text(items[item->index].span)));
    Diagnostics diagnostics;
    const std::optional<text::Document> reparsed = text::as_edited(exchanged);
    if (!reparsed) continue;
    if (format.read(std::span(&*reparsed, 1), options, diagnostics) && !diagnostics.has_errors()) return &items[other];
  }
  return nullptr;
}

const Node* named_in(const text::Document& document, std::string_view sentence) {
  std::string_view name = sentence.substr(0, sentence.find(' '));
  while (name.ends_with(':') || name.ends_with(',')) name.remove_suffix(1);
  return name.empty() ? nullptr : find_path(document.root(), name);
}

}  // namespace fca::checks
