// SPDX-License-Identifier: BSD-3-Clause
#include "exchange.h"

#include <fca/formats/text/read_document.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca::checks {

namespace {

using text::Node;

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

}  // namespace fca::checks
