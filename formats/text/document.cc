// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/document.h>

#include "markup.h"

#include <algorithm>
#include <utility>

namespace fca::text {

void Document::add_edit(Edit edit) {
  kept_.reset();
  edits_.push_back(std::move(edit));
}

const Node* first_copy(const Node& root) {
  if (root.copied) return &root;
  for (const Node& item : root.items) {
    if (const Node* copy = first_copy(item)) return copy;
  }
  for (const Entry& entry : root.entries) {
    if (const Node* copy = first_copy(entry.value)) return copy;
  }
  return nullptr;
}

void Document::replace(const Span& span, std::string text) { add_edit({span, std::move(text)}); }

std::vector<Span> Document::edited_spans() const {
  std::vector<Span> spans;
  spans.reserve(edits_.size());
  for (const Edit& edit : edits_) spans.push_back(edit.span);
  return spans;
}

namespace {

std::size_t end_of(const Entry& entry) { return std::max(entry.key.span.end(), entry.value.span.end()); }

bool contains(const std::vector<std::size_t>& offsets, std::size_t offset) {
  return std::ranges::find(offsets, offset) != offsets.end();
}

}  // namespace

Span Document::extent(const Entry& entry) const {
  if (syntax_ == Syntax::kXml) return element_span(source_.bytes, entry.key.span);
  return {entry.key.span.offset, end_of(entry) - entry.key.span.offset};
}

std::string_view Document::indentation_at(std::size_t offset) const {
  const std::string_view line = source_.text(source_.line_at(offset));
  return line.substr(0, std::min(line.find_first_not_of(" \t"), line.size()));
}

bool Document::begins_line(const Entry& entry) const {
  const std::size_t start = extent(entry).offset;
  return source_.line_at(start).offset + indentation_at(start).size() == start;
}

std::string Document::laid_out(std::string_view lines, std::string_view indentation) const {
  std::string text;
  for (const char c : lines) {
    if (c == '\n') {
      text += source_.line_break();
      text += indentation;
    } else {
      text += c;
    }
  }
  return text;
}

void Document::remove_entry(const Node& mapping, const Entry& entry) {
  if (syntax_ == Syntax::kXml) return remove_element(entry);
  if (mapping.flow) return remove_from_flow(mapping, entry);
  const std::size_t start = source_.line_at(entry.key.span.offset).offset;
  const std::size_t newline = source_.bytes.find('\n', end_of(entry));
  const std::size_t end = newline == std::string::npos ? source_.bytes.size() : newline + 1;
  replace({start, end - start}, "");
}

// Which comma goes with an entry depends on which of its neighbours stay, so all removals of the mapping are laid out again.
void Document::remove_from_flow(const Node& mapping, const Entry& entry) {
  const std::size_t owner = mapping.span.offset;
  removed_.push_back(entry.key.span.offset);
  std::erase_if(edits_, [owner](const Edit& edit) { return edit.owner == owner && edit.span.length > 0; });
  const std::vector<Entry>& entries = mapping.entries;
  const auto gone = [&](std::size_t i) { return contains(removed_, entries[i].key.span.offset); };
  for (std::size_t first = 0; first < entries.size(); ++first) {
    if (!gone(first)) continue;
    std::size_t behind = first + 1;
    while (behind < entries.size() && gone(behind)) ++behind;
    const bool takes_comma_behind = first == 0 && behind < entries.size();
    const std::size_t start = first == 0 ? entries[0].key.span.offset : end_of(entries[first - 1]);
    std::size_t end = takes_comma_behind ? entries[behind].key.span.offset : end_of(entries[behind - 1]);
    // Python takes a comma after the last value, and none alone.
    const std::size_t next = source_.bytes.find_first_not_of(" \t\r\n", end);
    const bool leaves_comma = first == 0 && !takes_comma_behind && next < source_.bytes.size() && source_.bytes[next] == ',';
    if (leaves_comma) end = next + 1;
    add_edit({{start, end - start}, "", owner});
    if (first == 0 && behind == entries.size()) emptied_.push_back(owner);
    first = behind;
  }
}

void Document::remove_element(const Entry& entry) {
  const std::string_view bytes = source_.bytes;
  const Span element = extent(entry);
  if (!begins_line(entry)) return replace(element, "");
  std::size_t rest = bytes.find_first_not_of(" \t\r", element.end());
  if (const std::optional<Markup> comment = next_markup(bytes, element.end());
      comment && comment->kind == Markup::Kind::kComment && comment->span.offset == rest) {
    const std::size_t behind = bytes.find_first_not_of(" \t\r", comment->span.end());
    const bool on_this_line = source_.text(comment->span).find('\n') == std::string_view::npos;
    // A remark after the element speaks of it.
    if (on_this_line && (behind == std::string_view::npos || bytes[behind] == '\n')) rest = behind;
  }
  const std::size_t line = source_.line_at(element.offset).offset;
  if (rest != std::string_view::npos && bytes[rest] == '\n') return replace({line, rest + 1 - line}, "");
  // The parent's closing tag follows: it moves to the end of the line before.
  std::size_t start = line;
  if (start > 0 && bytes[start - 1] == '\n') --start;
  if (start > 0 && bytes[start - 1] == '\r') --start;
  replace({start, element.end() - start}, "");
}

void Document::insert_after(const Node& mapping, const Entry& entry, const std::string& lines) {
  if (syntax_ == Syntax::kXml) return insert_element_after(entry, lines);
  if (mapping.flow) return insert_in_flow(mapping, entry, lines);
  const std::size_t column = entry.key.span.offset - source_.line_at(entry.key.span.offset).offset;
  const std::string indentation(column, ' ');
  const std::string text = indentation + laid_out(lines, indentation);
  const std::size_t newline = source_.bytes.find('\n', end_of(entry));
  if (newline == std::string::npos) {
    insert(source_.bytes.size(), std::string(source_.line_break()) + text);
  } else {
    insert(newline + 1, text + std::string(source_.line_break()));
  }
}

void Document::insert_in_flow(const Node& mapping, const Entry& entry, const std::string& lines) {
  std::string separator = ", ";
  std::string_view indentation;
  if (is_in_brackets(syntax_) && begins_line(entry)) {
    indentation = indentation_at(entry.key.span.offset);
    separator = "," + std::string(source_.line_break()) + std::string(indentation);
  }
  add_edit({{end_of(entry), 0}, separator + laid_out(lines, indentation), mapping.span.offset, separator.size()});
}

void Document::insert_element_after(const Entry& entry, const std::string& lines) {
  const Span element = extent(entry);
  if (!begins_line(entry)) return insert(element.end(), laid_out(lines, indentation_at(element.offset)));
  const std::string_view indentation = indentation_at(element.offset);
  const std::string text = std::string(indentation) + laid_out(lines, indentation);
  // After the line's remarks, but before a tag that follows on the same line.
  const std::string_view bytes = source_.bytes;
  const std::size_t newline = bytes.find('\n', element.end());
  std::optional<Markup> next = next_markup(bytes, element.end());
  while (next && next->kind == Markup::Kind::kComment && next->span.end() <= newline)
    next = next_markup(bytes, next->span.end());
  const bool ends_line = newline != std::string_view::npos && (!next || next->span.offset > newline);
  if (ends_line) {
    insert(newline + 1, text + std::string(source_.line_break()));
  } else {
    insert(element.end(), std::string(source_.line_break()) + text);
  }
}

std::string Document::bytes() const {
  std::vector<Edit> edits = edits_;
  // What is inserted where something else is removed stands before that: it belongs to what comes before.
  std::ranges::stable_sort(edits, {}, [](const Edit& edit) { return std::pair(edit.span.offset, edit.span.length > 0); });
  std::vector<std::size_t> emptied = emptied_;
  std::string result;
  std::size_t copied = 0;
  for (const Edit& edit : edits) {
    if (edit.span.offset < copied) continue;  // inside something removed
    result.append(source_.bytes, copied, edit.span.offset - copied);
    // The first of new entries has none before it to be separated from.
    const bool alone = edit.separator > 0 && std::erase(emptied, edit.owner) > 0;
    result += std::string_view(edit.text).substr(alone ? edit.separator : 0);
    copied = edit.span.end();
  }
  result.append(source_.bytes, copied, std::string::npos);
  return result;
}

}  // namespace fca::text
