// SPDX-License-Identifier: BSD-3-Clause
#include "fields.h"

#include "spelling.h"
#include "text/binary.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <utility>

namespace fca::fields {

using text::Node;

Field scalar(std::string key, std::string token) { return {std::move(key), Shape::kScalar, {std::move(token)}, 0, {}}; }
Field real(std::string key, double value) { return scalar(std::move(key), text::format_real(value)); }
Field integer(std::string key, int value) { return scalar(std::move(key), std::to_string(value)); }
Field quoted(std::string key, std::string_view value) { return scalar(std::move(key), quote(value)); }

Field list(std::string key, std::span<const double> values) {
  Field field{std::move(key), Shape::kList, {}, 0, {}};
  for (const double v : values) field.tokens.push_back(text::format_real(v));
  return field;
}

Field rows(std::string key, const Transform& T) {
  Field field = list(std::move(key), T.values);
  field.shape = Shape::kRows;
  field.columns = 4;
  return field;
}

Field matrix(std::string key, std::span<const double> values, int columns, std::string element_type) {
  Field field = list(std::move(key), values);
  field.shape = Shape::kMatrix;
  field.columns = columns;
  field.element_type = std::move(element_type);
  return field;
}

namespace {

/// Are they numbers or words that can be edited one by one?
bool are_scalars(std::span<const Node* const> items) {
  return std::ranges::all_of(items, [](const Node* item) { return item->is_scalar() && item->span.length > 0; });
}

/// Makes as many items as there are tokens say those. What the field before says as well is not touched, whatever its spelling:
/// the int in a list of reals was there before, and the program had its chance to refuse it.
void edit_common_items(text::Document& document, std::span<const Node* const> items, const Field* before, const Field& field) {
  const std::span<const std::string> tokens = field.tokens;
  const bool comparable = before != nullptr && before->shape == field.shape && before->tokens.size() == items.size();
  for (std::size_t i = 0; i < std::min(items.size(), tokens.size()); ++i) {
    if (!comparable || before->tokens[i] != tokens[i]) set_scalar(document, *items[i], tokens[i]);
  }
}

/// Edits the numbers of a sequence in place; false if the layout does not allow it.
bool edit_items(text::Document& document, std::span<const Node* const> items, const Field* before, const Field& field) {
  if (items.size() != field.tokens.size() || !are_scalars(items)) return false;
  edit_common_items(document, items, before, field);
  return true;
}

/// The same of a sequence that is to be longer or shorter: what it has too many go from its end, and new ones follow each
/// other as its first two do.
bool resize_items(text::Document& document, std::span<const Node* const> items, const Field* before, const Field& field) {
  const std::span<const std::string> tokens = field.tokens;
  if (items.size() < 2 || tokens.empty() || !are_scalars(items)) return false;
  const auto between = [&](std::size_t from, std::size_t to) { return text::Span{from, to - from}; };
  const text::Span separator = between(items[0]->span.end(), items[1]->span.offset);
  const text::Span beyond = tokens.size() < items.size()
                                ? between(items[tokens.size() - 1]->span.end(), items.back()->span.end())
                                : text::Span{items.back()->span.end(), 0};
  const std::string separating = document.source().bytes.substr(separator.offset, separator.length);
  const std::string going = document.source().bytes.substr(beyond.offset, beyond.length);
  // A comment belongs to its line.
  if ((separating + going).find_first_of("#<") != std::string::npos) return false;
  edit_common_items(document, items.first(std::min(items.size(), tokens.size())), before, field);
  std::string more;
  for (std::size_t i = items.size(); i < tokens.size(); ++i) more += separating + spell_token(tokens[i], document.syntax());
  document.replace(beyond, more);
  return true;
}

std::vector<const Node*> leaves(const Node& node) {
  if (!node.is_sequence()) return {&node};
  std::vector<const Node*> result;
  for (const Node& item : node.items) {
    const std::vector<const Node*> below = leaves(item);
    result.insert(result.end(), below.begin(), below.end());
  }
  return result;
}

/// A list. XML says one of one number as it says a number.
bool is_list(const text::Document& document, const Node& node) {
  return node.is_sequence() || (node.is_scalar() && document.syntax() == text::Syntax::kXml);
}

/// Is a matrix of `count` numbers a vector that lies as the field's and is of another length?
bool is_longer_or_shorter(const Node& rows, const Node& cols, std::size_t count, const Field& field) {
  if (count == field.tokens.size()) return false;
  const bool column = field.columns == 1;
  const bool row = static_cast<std::size_t>(field.columns) == field.tokens.size();
  return (column && cols.value == "1" && rows.value == std::to_string(count)) ||
         (row && rows.value == "1" && cols.value == std::to_string(count));
}

bool edit_in_place(text::Document& document, const Node& value, text::Dialect dialect, const Field* before,
                   const Field& field) {
  switch (field.shape) {
    case Shape::kScalar:
      return value.is_scalar() && edit_items(document, std::vector{&value}, before, field);
    case Shape::kList:
    case Shape::kRows:
      return is_list(document, value) && edit_items(document, leaves(value), before, field);
    case Shape::kMatrix: {
      // Some write a matrix as a plain list.
      if (value.is_sequence()) return edit_items(document, leaves(value), before, field);
      const Node* data = value.is_mapping() ? text::find(value, "data", dialect) : nullptr;
      const Node* cols = value.is_mapping() ? text::find(value, "cols", dialect) : nullptr;
      const Node* type = value.is_mapping() ? text::find(value, "dt", dialect) : nullptr;
      const Node* rows = value.is_mapping() ? text::find(value, "rows", dialect) : nullptr;
      if (data == nullptr || rows == nullptr || cols == nullptr || type == nullptr || !is_list(document, *data)) return false;
      // The same digits are another number in a matrix of another type.
      const bool same_type = type->value == field.element_type;
      const Field* comparable = same_type ? before : nullptr;
      if (is_longer_or_shorter(*rows, *cols, leaves(*data).size(), field)) {
        if (!resize_items(document, leaves(*data), comparable, field)) return false;
        set_scalar(document, field.columns == 1 ? *rows : *cols, std::to_string(field.tokens.size()));
      } else if (cols->value != std::to_string(field.columns) || !edit_items(document, leaves(*data), comparable, field)) {
        return false;
      }
      if (!same_type) set_scalar(document, *type, field.element_type);
      return true;
    }
  }
  return false;
}

/// `text` with `indentation` before every line but the first, and the document's line breaks.
std::string indented(std::string_view text, std::string_view indentation, std::string_view line_break) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += line_break;
      result += indentation;
    } else {
      result += c;
    }
  }
  return result;
}

bool is_yaml(const text::Document& document) {
  return document.syntax() == text::Syntax::kYaml || document.syntax() == text::Syntax::kOpenCvYaml;
}

/// Must a new value next to `entry` do without line breaks?
bool on_one_line(const text::Document& document, const Node& mapping, const text::Entry& entry) {
  return is_yaml(document) ? mapping.flow : !document.begins_line(entry);
}

/// How the mapping that `entry` holds is laid out.
Style style_of(const text::Document& document, const text::Entry& entry) {
  const text::Span extent = document.extent(entry);
  const std::string_view bytes = std::string_view(document.source().bytes).substr(extent.offset, extent.length);
  if (is_yaml(document) ? entry.value.flow : bytes.find('\n') == std::string_view::npos) return {true, 0};
  const auto column = [&document](const Node& key) { return document.indentation_at(key.span.offset).size(); };
  const std::size_t inner = column(entry.value.entries.front().key);
  const std::size_t outer = column(entry.key);
  return {false, inner > outer ? inner - outer : 0};
}

/// How a field is laid out in a mapping: a matrix as the one that is replaced (the value of `entry`), else as the first one of
/// the mapping.
Style style_for(const text::Document& document, const Node& mapping, const text::Entry& entry, const Field& field) {
  if (on_one_line(document, mapping, entry)) return {true, 0};
  if (field.shape != Shape::kMatrix) return {};
  const auto is_matrix = [](const text::Entry& other) {
    return std::ranges::any_of(other.value.entries, [](const text::Entry& inner) { return inner.key.value == "data"; });
  };
  if (entry.key.value == field.key && is_matrix(entry)) return style_of(document, entry);
  const auto first = std::ranges::find_if(mapping.entries, is_matrix);
  return first == mapping.entries.end() ? Style{} : style_of(document, *first);
}

/// A list of another length in a YAML block list's own style: "\n" and its dash before every number. Nothing of other lists.
std::optional<std::string> as_block_list(const text::Document& document, const Node& value, const Field& field) {
  if (!is_yaml(document) || field.shape != Shape::kList || !value.is_sequence() || value.flow) return std::nullopt;
  if (value.items.empty() || field.tokens.empty()) return std::nullopt;
  const std::string& bytes = document.source().bytes;
  const std::size_t item = value.items.front().span.offset;
  const std::size_t line = document.source().line_at(item).offset;
  const std::string before = bytes.substr(line, item - line);
  if (before.find_first_not_of(" -") != std::string::npos || std::ranges::count(before, '-') != 1) return std::nullopt;
  std::string text;
  for (const std::string& token : field.tokens) text += std::string(document.source().line_break()) + before + token;
  return text;
}

void replace_value(text::Document& document, const Node& mapping, const text::Entry& entry, const Field& field) {
  const text::Source& source = document.source();
  if (const std::optional<std::string> items = as_block_list(document, entry.value, field)) {
    const std::size_t start = source.bytes.find(':', entry.key.span.end()) + 1;
    document.replace({start, entry.value.span.end() - start}, *items);
    return;
  }
  const std::string value = spell_value(field, document.syntax(), style_for(document, mapping, entry, field));
  text::Span span = entry.value.span;
  std::string indentation(document.indentation_at(entry.key.span.offset));
  if (document.syntax() == text::Syntax::kXml) {
    span = document.extent(entry);
  } else if (!text::is_in_brackets(document.syntax())) {
    const std::size_t colon = source.bytes.find(':', entry.key.span.end());
    const std::size_t start = colon == std::string::npos ? entry.key.span.end() : colon + 1;
    span = {start, std::max(start, entry.value.span.end()) - start};
    indentation.assign(entry.key.span.offset - source.line_at(entry.key.span.offset).offset, ' ');
  }
  document.replace(span, indented(value, indentation, source.line_break()));
}

/// A new transform as another one of the mapping is laid out; nothing if there is none to follow.
std::optional<std::string> like_neighbour(const text::Document& document, const Node& mapping, const Field& field) {
  if (!is_yaml(document) || mapping.flow || field.shape != Shape::kRows) return std::nullopt;
  const std::string& bytes = document.source().bytes;
  for (const text::Entry& entry : mapping.entries) {
    const std::vector<const Node*> numbers = leaves(entry.value);
    if (!entry.value.is_sequence() || entry.key.quoted || numbers.size() != field.tokens.size()) continue;
    std::string text = field.key;
    std::size_t copied = entry.key.span.end();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      text += bytes.substr(copied, numbers[i]->span.offset - copied) + field.tokens[i];
      copied = numbers[i]->span.end();
    }
    text += bytes.substr(copied, entry.value.span.end() - copied);
    if (text.find('#') != std::string::npos) continue;
    const std::size_t column = entry.key.span.offset - document.source().line_at(entry.key.span.offset).offset;
    return unindented(text, std::string(column, ' '));
  }
  return std::nullopt;
}

const Field* find_field(std::span<const Field> fields, std::string_view key) {
  const auto found = std::ranges::find(fields, key, &Field::key);
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace

std::string unindented(std::string_view text, std::string_view indentation) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    result += text[i];
    if (text[i] == '\n' && text.substr(i + 1).starts_with(indentation)) i += indentation.size();
  }
  return result;
}

std::string spell(const Field& field, std::size_t indentation, text::Syntax syntax) {
  const std::string blanks(indentation, ' ');
  return blanks + indented(spell_entry(field, syntax, {}), blanks, "\n");
}

std::string value_text(const Node& value) {
  if (value.is_scalar()) return value.value;
  const auto inside = [](const Node& node) {
    const std::optional<double> number =
        node.is_scalar() && node.value.find_first_of(".eE") != std::string::npos ? text::parse_real(node.value) : std::nullopt;
    return number ? text::format_real(*number) : value_text(node);
  };
  std::string text;
  for (const Node& item : value.items) text += (text.empty() ? "" : ", ") + inside(item);
  for (const text::Entry& entry : value.entries)
    text += (text.empty() ? "" : ", ") + entry.key.value + ": " + inside(entry.value);
  if (value.is_mapping()) return "{" + text + "}";
  return value.is_sequence() ? "[" + text + "]" : text;
}

void set_scalar(text::Document& document, const Node& scalar, const std::string& token) {
  if (says(scalar, token, document.syntax())) return;
  const std::string spelled = spell_token(token, document.syntax());
  const bool binary = document.syntax() == text::Syntax::kBinary;
  document.replace(scalar.span, binary ? text::encoded(scalar.tag, spelled) : spelled);
}

void apply(text::Document& document, const Node& mapping, text::Dialect dialect, std::span<const Field> before,
           std::span<const Field> after) {
  const text::Entry* predecessor = nullptr;
  for (const Field& field : after) {
    const Field* old = find_field(before, field.key);
    const text::Entry* entry = text::find_entry(mapping, field.key, dialect);
    if (entry == nullptr) {
      // Equal to before and yet not there: the file never said it, and it need not begin to.
      if (old != nullptr && *old == field) continue;
      const text::Entry* anchor = predecessor;
      if (anchor == nullptr && !mapping.entries.empty()) anchor = &mapping.entries.back();
      if (anchor != nullptr) {
        const Style style = style_for(document, mapping, *anchor, field);
        const std::optional<std::string> alike = like_neighbour(document, mapping, field);
        document.insert_after(mapping, *anchor, alike ? *alike : spell_entry(field, document.syntax(), style));
      }
      continue;
    }
    predecessor = entry;
    if (old != nullptr && *old == field) continue;
    if (!edit_in_place(document, entry->value, dialect, old, field)) replace_value(document, mapping, *entry, field);
  }
  for (const Field& field : before) {
    if (find_field(after, field.key) != nullptr) continue;
    if (const text::Entry* entry = text::find_entry(mapping, field.key, dialect)) document.remove_entry(mapping, *entry);
  }
}

}  // namespace fca::fields
