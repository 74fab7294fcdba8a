// SPDX-License-Identifier: BSD-3-Clause
// Where XML's tags stand. tinyxml2 says what a document holds, but neither where an element ends nor in which column it is
// wrong.
#pragma once

#include "refusal.h"

#include <optional>
#include <string_view>

namespace fca::text {

/// What begins with '<' and ends with '>'.
struct Markup {
  enum class Kind { kOpen, kClose, kEmpty, kComment, kInstruction, kOther, kUnfinished };
  Kind kind = Kind::kOther;
  Span span;
  Span name;  ///< kOpen, kClose, kEmpty: the element's.
};

/// The first markup at or after `from`; nothing if no '<' follows.
[[nodiscard]] std::optional<Markup> next_markup(std::string_view bytes, std::size_t from);

/// From the '<' of an element's opening tag to the '>' of its closing one. `name`: its name in the opening tag.
[[nodiscard]] Span element_span(std::string_view bytes, const Span& name);

/// The first thing that makes a document no XML of one root, or one that we do not take: a tag without its partner, a document
/// type, nesting deeper than kMaxDepth.
[[nodiscard]] std::optional<Refusal> check_markup(const Source& source);

}  // namespace fca::text
