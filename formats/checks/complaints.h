// SPDX-License-Identifier: BSD-3-Clause
// What a program's complaint is about, and what is said in it.
#pragma once

#include <fca/formats/text/document.h>
#include <fca/message.h>

#include <string_view>
#include <variant>
#include <vector>

namespace fca::checks {

/// What stands in the document under a complaint's key ("cam0/intrinsics"); where it is missing, the key of its owner. Null if
/// there is neither.
[[nodiscard]] const text::Node* node_at(const text::Document& document, std::string_view key);

/// The message, or the first clause in it, that is one; null if there is none.
template <class Is>
[[nodiscard]] const Message* find_clause(const Message& message, const Is& is) {
  if (is(message)) return &message;
  for (const Argument& argument : message.arguments) {
    const auto* const clauses = std::get_if<std::vector<Message>>(&argument.value);
    if (clauses == nullptr) continue;
    for (const Message& clause : *clauses) {
      if (const Message* const found = find_clause(clause, is)) return found;
    }
  }
  return nullptr;
}

}  // namespace fca::checks
