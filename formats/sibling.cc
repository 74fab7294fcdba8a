// SPDX-License-Identifier: BSD-3-Clause
#include "sibling.h"

#include "text/comments.h"

#include <algorithm>
#include <vector>

namespace fca::fields {

using text::Document;
using text::Entry;
using text::Node;
using text::Span;
using text::Syntax;

namespace {

bool is_xml(const Document& document) { return document.syntax() == Syntax::kXml; }

/// A comment belongs to the camera next to which it stands: with the blanks before it and, on a line of its own, the line.
void remove_comments(Document& document, const Span& region) {
  const std::string& bytes = document.source().bytes;
  const char* const blanks = is_xml(document) ? " \t\r\n" : " \t";
  for (const Span& comment : text::comments_of(document)) {
    if (comment.offset < region.offset || comment.offset >= region.end()) continue;
    const std::size_t behind_text = comment.offset == 0 ? 0 : bytes.find_last_not_of(blanks, comment.offset - 1) + 1;
    const bool own_line = !is_xml(document) && (behind_text == 0 || bytes[behind_text - 1] == '\n');
    const std::size_t end = own_line ? std::min(bytes.find('\n', comment.end()), bytes.size() - 1) + 1 : comment.end();
    document.replace({behind_text, end - behind_text}, "");
  }
}

void rename(Document& document, const Entry& entry, std::string_view key) {
  const std::string name = entry.key.quoted ? '"' + std::string(key) + '"' : std::string(key);
  document.replace(entry.key.span, name);
  if (!is_xml(document)) return;
  const std::size_t closing = document.source().bytes.rfind("</", document.extent(entry).end() - 1);
  document.replace({closing + 2, entry.key.value.size()}, name);
}

bool has(std::span<const Field> fields, const std::string& key) {
  return std::ranges::find(fields, key, &Field::key) != fields.end();
}

}  // namespace

std::string like_sibling(const Document& base, const Node& mapping, const Entry& sibling, text::Dialect dialect,
                         std::string_view key, std::span<const Field> before, std::span<const Field> after) {
  Document copy = base;
  const std::string& bytes = base.source().bytes;
  Span region = base.extent(sibling);
  const bool whole_lines = !mapping.flow && !is_xml(base);
  if (whole_lines) {
    const std::size_t newline = bytes.find('\n', region.end());
    region.length = (newline == std::string::npos ? bytes.size() : newline + 1) - region.offset;
  }
  rename(copy, sibling, key);
  for (const Entry& entry : sibling.value.entries) {
    const bool counts = text::find_entry(sibling.value, entry.key.value, dialect) == &entry;
    const bool known = has(before, entry.key.value) || has(after, entry.key.value);
    if (!counts || !known) copy.remove_entry(sibling.value, entry);
  }
  apply(copy, sibling.value, dialect, before, after);
  remove_comments(copy, region);
  const std::string edited = copy.bytes();
  const std::size_t behind = bytes.size() - region.end();
  std::string text = edited.substr(region.offset, edited.size() - behind - region.offset);
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return unindented(text, base.indentation_at(region.offset));
}

}  // namespace fca::fields
