// SPDX-License-Identifier: BSD-3-Clause
#include "layout_mend.h"

#include <algorithm>
#include <vector>

namespace fca::checks {

namespace {

using text::Node;
using text::Span;

/// In bytes from the line's first.
std::size_t column_of(const text::Source& source, const Span& span) { return span.offset - source.line_at(span.offset).offset; }

/// The block sequences whose dashes stand no deeper than their key, in file order; what is inside one moves with it.
void collect_shallow(const text::Source& source, const Node& node, std::vector<Span>& spans) {
  for (const text::Entry& entry : node.entries) {
    const bool is_block = entry.value.is_sequence() && !entry.value.flow && entry.value.span.length > 0;
    if (is_block && column_of(source, entry.value.span) <= column_of(source, entry.key.span)) {
      spans.push_back(entry.value.span);
    } else {
      collect_shallow(source, entry.value, spans);
    }
  }
  for (const Node& item : node.items) collect_shallow(source, item, spans);
}

/// Do these bytes begin with the document's mark, behind blank lines and comments?
bool begins_with_mark(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t first = bytes.find_first_not_of(" \r\n");
    if (first == std::string_view::npos) return false;
    bytes.remove_prefix(first);
    if (!bytes.starts_with("#")) break;
    bytes.remove_prefix(std::min(bytes.find('\n'), bytes.size()));
  }
  return bytes.starts_with("---");
}

/// %YAML 1.2 for what follows, and the mark where it is missing, each in a line; the last without its line break.
std::string header_for(const text::Source& source, std::size_t rest) {
  const bool marked = begins_with_mark(std::string_view(source.bytes).substr(std::min(rest, source.bytes.size())));
  return marked ? "%YAML 1.2" : "%YAML 1.2" + std::string(source.line_break()) + "---";
}

std::string in_words(const std::string& header) {
  return header.ends_with("---") ? "%YAML 1.2 and, in a line of its own, ---" : "%YAML 1.2";
}

/// Where values follow their key's colon without a blank, which OpenCV's reader alone takes.
void collect_unspaced(const text::Source& source, const Node& node, std::vector<std::size_t>& places) {
  for (const text::Entry& entry : node.entries) {
    const Span between = {entry.key.span.end(),
                          entry.value.span.offset - std::min(entry.value.span.offset, entry.key.span.end())};
    if (entry.value.span.length > 0 && source.text(between) == ":") places.push_back(entry.value.span.offset);
    collect_unspaced(source, entry.value, places);
  }
  for (const Node& item : node.items) collect_unspaced(source, item, places);
}

}  // namespace

std::optional<Mend> header_mend(const text::Document& document) {
  const text::Source& source = document.source();
  const std::size_t start = source.byte_order_mark();
  if (!std::string_view(source.bytes).substr(start).starts_with("%YAML:")) return std::nullopt;
  const Span line = source.line_at(start);
  const std::string header = header_for(source, line.end());
  std::string text = header;
  std::size_t at = line.end();
  std::vector<std::size_t> unspaced;
  collect_unspaced(source, document.root(), unspaced);
  for (const std::size_t place : unspaced) {
    text += std::string(source.text({at, place - at})) + " ";
    at = place;
  }
  return Mend{"opencv-header",
              {line.offset, at - line.offset},
              text,
              "write " + in_words(header) + (unspaced.empty() ? "" : "; and a blank behind every colon")};
}

std::optional<Mend> layout_mend(const text::Document& document) {
  if (document.syntax() != text::Syntax::kYaml) return std::nullopt;
  const text::Source& source = document.source();
  // A header behind comments: which of the two is meant to go is not certain.
  if (source.bytes.find("\n%YAML") != std::string::npos) return std::nullopt;
  std::vector<Span> shallow;
  collect_shallow(source, document.root(), shallow);
  const std::size_t start = source.byte_order_mark();
  const bool has_header = std::string_view(source.bytes).substr(start).starts_with("%YAML");
  if (has_header && shallow.empty()) return std::nullopt;
  const std::string header = has_header ? "" : header_for(source, start);
  // From the byte order mark, which OpenCV does not take for one, or from the first list.
  const std::size_t begin = has_header ? source.line_at(shallow.front().offset).offset : 0;
  std::size_t at = has_header ? begin : start;
  std::string text = has_header ? "" : header + std::string(source.line_break());
  for (const Span& list : shallow) {
    const std::size_t first = source.line_at(list.offset).offset;
    text += source.text({at, first - at});
    for (at = first; at < list.end();) {
      const Span line = source.line_at(at);
      const std::size_t next = std::min(source.bytes.find('\n', line.end()), source.bytes.size() - 1) + 1;
      text += (line.length > 0 ? "  " : "") + std::string(source.text({line.offset, next - line.offset}));
      at = next;
    }
  }
  const std::string first = has_header ? "" : "begin the file with " + in_words(header);
  const std::string lists = shallow.empty() ? "" : "indent lists deeper than their key";
  return Mend{"yaml-layout", {begin, at - begin}, text, first + (first.empty() || lists.empty() ? "" : "; ") + lists};
}

}  // namespace fca::checks
