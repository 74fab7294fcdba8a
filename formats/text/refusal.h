// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/code.h>
#include <fca/diagnostics.h>
#include <fca/formats/text/source.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace fca::text {

/// Why a document is refused, and where in the source.
struct Refusal {
  Message message;
  std::size_t offset = 0;
};

/// At the end of the file, where what is missing would stand, the range is empty.
inline void report(const Refusal& refusal, const Source& source, Diagnostics& diagnostics) {
  const std::size_t length = refusal.offset < source.bytes.size() ? 1 : 0;
  diagnostics.add(refusal.message.code, refusal.message.arguments,
                  source.range({std::min(refusal.offset, source.bytes.size()), length}));
}

/// What brackets, lists or elements are refused with that are nested deeper than kMaxDepth (node.h).
[[nodiscard]] Refusal too_deep(std::size_t offset);

/// What a list is refused with that has kLongestList values (limits.h) and goes on at `offset`.
[[nodiscard]] Refusal too_long(std::size_t offset);

/// What git left in a file, in better words than a parser's.
[[nodiscard]] std::optional<Refusal> find_conflict_marker(const Source& source);

}  // namespace fca::text
