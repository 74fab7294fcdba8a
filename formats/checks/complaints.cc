// SPDX-License-Identifier: BSD-3-Clause
#include "complaints.h"

#include <fca/formats/text/dialect.h>

namespace fca::checks {

namespace {

using text::Node;

/// Keys may themselves hold a '/'.
const Node* find_path(const Node& mapping, std::string_view path) {
  if (const text::Entry* entry = text::find_entry(mapping, path, text::Dialect::kOpenCv))
    return entry->value.span.length > 0 ? &entry->value : &entry->key;
  for (std::size_t at = path.find('/'); at != std::string_view::npos; at = path.find('/', at + 1)) {
    const text::Entry* owner = text::find_entry(mapping, path.substr(0, at), text::Dialect::kOpenCv);
    if (owner == nullptr) continue;
    if (owner->value.is_mapping()) {
      if (const Node* found = find_path(owner->value, path.substr(at + 1))) return found;
    }
    return &owner->key;  // the key itself is missing there
  }
  return nullptr;
}

}  // namespace

const Node* node_at(const text::Document& document, std::string_view key) {
  return key.empty() ? nullptr : find_path(document.root(), key);
}

}  // namespace fca::checks
