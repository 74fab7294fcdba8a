// SPDX-License-Identifier: BSD-3-Clause
#include "layout_fix.h"

#include <fca/code.h>

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

/// Do these bytes begin with the document's mark, after blank lines and comments?
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

Message named(const std::string& header) {
  return {header.ends_with("---") ? Code::kHeaderWithMark : Code::kHeaderWithoutMark};
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

/// Where %YAML stands: in the first line that is neither blank nor a comment. What is before it OpenCV's reader does not take.
struct Top {
  std::size_t start = 0;       ///< After a byte order mark.
  std::optional<Span> header;  ///< The line, without its break.

  [[nodiscard]] bool is_first() const { return header && header->offset == 0; }
};

Top top_of(const text::Source& source) {
  Top top;
  top.start = source.byte_order_mark();
  for (std::size_t at = top.start; at < source.bytes.size();) {
    const std::size_t end = std::min(source.bytes.find('\n', at), source.bytes.size());
    const std::string_view line = std::string_view(source.bytes).substr(at, end - at);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (line.starts_with("%YAML")) top.header = Span{at, line.size() - (line.ends_with('\r') ? 1 : 0)};
    if (first != std::string_view::npos && line[first] != '#') break;
    at = end + 1;
  }
  return top;
}

/// The lines before the header, after a line break and without their last one.
std::string lines_before(const text::Source& source, const Top& top) {
  std::string_view lines = source.text({top.start, top.header->offset - top.start});
  if (lines.empty()) return "";
  lines.remove_suffix(lines.ends_with("\r\n") ? 2 : 1);
  return std::string(source.line_break()) + std::string(lines);
}

/// What takes the header to the first byte.
std::vector<Message> steps_to_top(const text::Source& source, const Top& top) {
  std::vector<Message> steps;
  if (top.start > 0) steps.push_back({Code::kLayoutWithoutMark});
  if (top.header->offset > top.start) steps.push_back({Code::kLayoutBegins, {source.text(*top.header)}});
  return steps;
}

Message stops_at_error(const std::vector<Message>& steps) {
  std::vector<Message> clauses;
  clauses.reserve(steps.size());
  for (const Message& step : steps) clauses.push_back(clauses.empty() ? step : Message{Code::kLayoutThen, {step}});
  return {Code::kLayoutOfOpenCv, {clauses}};
}

}  // namespace

std::optional<Fix> header_fix(const text::Document& document) {
  const text::Source& source = document.source();
  const Top top = top_of(source);
  if (!top.header || !source.text(*top.header).starts_with("%YAML:")) return std::nullopt;
  const Span line = *top.header;
  const std::string header = header_for(source, line.end());
  std::string text = header + lines_before(source, top);
  std::size_t at = line.end();
  std::vector<std::size_t> unspaced;
  collect_unspaced(source, document.root(), unspaced);
  for (const std::size_t place : unspaced) {
    text += std::string(source.text({at, place - at})) + " ";
    at = place;
  }
  std::vector<Message> besides;
  if (line.offset > top.start) besides.push_back({Code::kHeaderInFirstLine});
  if (!unspaced.empty()) besides.push_back({Code::kBlanksAfterColons});
  return Fix{{Code::kHeaderOfYaml, {named(header), besides}}, {0, at}, text};
}

std::optional<Fix> layout_fix(const text::Document& document) {
  if (document.syntax() != text::Syntax::kYaml && document.syntax() != text::Syntax::kOpenCvYaml) return std::nullopt;
  const text::Source& source = document.source();
  const Top top = top_of(source);
  // A header in the midst of the file: which part of it is meant is not certain.
  if (!top.header && source.bytes.find("\n%YAML") != std::string::npos) return std::nullopt;
  std::vector<Span> shallow;
  collect_shallow(source, document.root(), shallow);
  if (top.is_first() && shallow.empty()) return std::nullopt;
  // From the first byte, or from the first list.
  std::size_t begin = 0;
  std::size_t at = top.start;
  std::string text;
  std::vector<Message> steps;
  if (top.is_first()) {
    begin = at = source.line_at(shallow.front().offset).offset;
  } else if (top.header) {
    at = top.header->end();
    text = std::string(source.text(*top.header)) + lines_before(source, top);
    steps = steps_to_top(source, top);
  } else {
    const std::string header = header_for(source, top.start);
    text = header + std::string(source.line_break());
    steps.push_back({Code::kLayoutBegins, {named(header)}});
  }
  for (const Span& list : shallow) {
    const std::size_t start = source.line_at(list.offset).offset;
    text += source.text({at, start - at});
    for (at = start; at < list.end();) {
      const Span line = source.line_at(at);
      const std::size_t next = std::min(source.bytes.find('\n', line.end()), source.bytes.size() - 1) + 1;
      text += (line.length > 0 ? "  " : "") + std::string(source.text({line.offset, next - line.offset}));
      at = next;
    }
  }
  if (!shallow.empty()) steps.push_back({Code::kLayoutIndented});
  return Fix{stops_at_error(steps), {begin, at - begin}, text};
}

}  // namespace fca::checks
