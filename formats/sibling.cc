// SPDX-License-Identifier: BSD-3-Clause
#include "sibling.h"

#include "text/markup.h"

#include <algorithm>
#include <vector>

namespace fca::fields {

using text::Document;
using text::Entry;
using text::Node;
using text::Span;
using text::Syntax;

namespace {

void collect_scalars(const Node& node, std::vector<Span>& spans) {
  if (node.is_scalar()) spans.push_back(node.span);
  for (const Node& item : node.items) collect_scalars(item, spans);
  for (const Entry& entry : node.entries) {
    spans.push_back(entry.key.span);
    collect_scalars(entry.value, spans);
  }
}

/// YAML: a '#' behind a blank, outside of all scalars.
void remove_hash_comments(Document& document, const Node& value, const Span& region) {
  const std::string& bytes = document.source().bytes;
  std::vector<Span> scalars;
  collect_scalars(value, scalars);
  const auto in_scalar = [&scalars](std::size_t offset) {
    return std::ranges::any_of(scalars, [offset](const Span& span) { return offset >= span.offset && offset < span.end(); });
  };
  for (std::size_t hash = bytes.find('#', region.offset); hash < region.end(); hash = bytes.find('#', hash + 1)) {
    const bool begins = hash == 0 || std::string_view(" \t\n").find(bytes[hash - 1]) != std::string_view::npos;
    if (!begins || in_scalar(hash)) continue;
    const std::size_t newline = std::min(bytes.find('\n', hash), bytes.size());
    const std::size_t behind_text = bytes.find_last_not_of(" \t", hash - 1) + 1;
    const bool own_line = behind_text == 0 || bytes[behind_text - 1] == '\n';
    std::size_t end = own_line ? std::min(newline + 1, bytes.size()) : newline;
    if (!own_line && end > hash && bytes[end - 1] == '\r') --end;
    document.replace({behind_text, end - behind_text}, "");
    hash = newline - 1;
  }
}

void remove_xml_comments(Document& document, const Span& region) {
  const std::string& bytes = document.source().bytes;
  std::optional<text::Markup> markup = text::next_markup(bytes, region.offset);
  for (; markup && markup->span.offset < region.end(); markup = text::next_markup(bytes, markup->span.end())) {
    if (markup->kind != text::Markup::Kind::kComment) continue;
    const std::size_t behind_text = bytes.find_last_not_of(" \t\r\n", markup->span.offset - 1) + 1;
    document.replace({behind_text, markup->span.end() - behind_text}, "");
  }
}

void rename(Document& document, const Entry& entry, std::string_view key) {
  const std::string name = entry.key.quoted ? '"' + std::string(key) + '"' : std::string(key);
  document.replace(entry.key.span, name);
  if (document.syntax() != Syntax::kXml) return;
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
  const bool whole_lines = !mapping.flow && base.syntax() != Syntax::kXml;
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
  if (base.syntax() == Syntax::kXml) {
    remove_xml_comments(copy, region);
  } else if (base.syntax() != Syntax::kJson) {
    remove_hash_comments(copy, sibling.value, region);
  }
  const std::string edited = copy.bytes();
  const std::size_t behind = bytes.size() - region.end();
  std::string text = edited.substr(region.offset, edited.size() - behind - region.offset);
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return unindented(text, base.indentation_at(region.offset));
}

}  // namespace fca::fields
