// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include "refusal.h"

#include <fca/formats/text/limits.h>

#include <algorithm>

namespace fca::text {

namespace {

/// As C's isspace, which is what the programs' scanf goes by.
constexpr std::string_view kBlanks = " \t\r\v\f";

/// Throws a Refusal of a line that is too long.
Node split(std::string_view bytes, std::size_t start, std::size_t end) {
  Node line;
  line.kind = NodeKind::kSequence;
  line.span = {start, 0};
  const std::string_view text = bytes.substr(0, end);
  for (std::size_t at = text.find_first_not_of(kBlanks, start); at != std::string_view::npos;) {
    const std::size_t word_end = std::min(text.find_first_of(kBlanks, at), end);
    if (line.items.size() == kLongestList) throw too_long(at);
    Node word;
    word.kind = NodeKind::kScalar;
    word.span = {at, word_end - at};
    word.value = text.substr(at, word_end - at);
    line.items.push_back(std::move(word));
    at = text.find_first_not_of(kBlanks, word_end);
  }
  if (line.items.empty()) return line;
  line.span.offset = line.items.front().span.offset;
  line.span.length = line.items.back().span.end() - line.span.offset;
  if (line.items.front().value.starts_with('#')) line.tag = kCommentTag;
  return line;
}

}  // namespace

std::optional<Node> parse_words(const Source& source, Diagnostics& diagnostics) {
  if (const std::optional<Refusal> conflict = find_conflict_marker(source)) {
    report(*conflict, source, diagnostics);
    return std::nullopt;
  }
  const std::string_view bytes = source.bytes;
  Node root;
  root.kind = NodeKind::kSequence;
  root.span = {source.byte_order_mark(), bytes.size() - source.byte_order_mark()};
  try {
    for (std::size_t start = root.span.offset; start < bytes.size();) {
      const std::size_t end = std::min(bytes.find('\n', start), bytes.size());
      if (root.items.size() == kLongestList) throw too_long(start);
      root.items.push_back(split(bytes, start, end));
      start = end + 1;
    }
  } catch (const Refusal& refusal) {
    report(refusal, source, diagnostics);
    return std::nullopt;
  }
  return root;
}

}  // namespace fca::text
