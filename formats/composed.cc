// SPDX-License-Identifier: BSD-3-Clause
#include "composed.h"

#include <fca/formats/text/limits.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace fca {

namespace {

using fields::Field;
using fields::Shape;
using text::Node;
using text::NodeKind;

bool is_letter_or_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// A number, a word or a topic that YAML takes as it stands, in lists, too.
bool is_plain_word(std::string_view token) {
  constexpr std::array<std::string_view, 3> kNull = {"null", "Null", "NULL"};
  if (std::ranges::find(kNull, token) != kNull.end()) return false;
  const std::string_view unsigned_part = token.substr(token.starts_with('-') ? 1 : 0);
  if (unsigned_part.empty() || !(is_letter_or_digit(unsigned_part[0]) || token[0] == '/')) return false;
  return std::ranges::all_of(unsigned_part, [](char c) {
    return is_letter_or_digit(c) || std::string_view("_/.+-").find(c) != std::string_view::npos;
  });
}

/// Text in double quotes that stands there letter by letter.
bool is_plain_text(std::string_view token) {
  if (token.size() < 2 || !token.starts_with('"') || !token.ends_with('"')) return false;
  return std::ranges::all_of(token.substr(1, token.size() - 2),
                             [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

bool is_plain_key(std::string_view key) {
  constexpr std::size_t kLongestKey = 1000;  // YAML's own limit is 1024 characters with the colon
  return key.size() <= kLongestKey && is_plain_word(key);
}

bool is_plain(const Field& field) {
  const bool list = field.shape == Shape::kList;
  const bool matrix = field.shape == Shape::kMatrix;
  if (!is_plain_key(field.key) || (field.tokens.empty() && !list)) return false;
  if (matrix && !is_plain_word(field.element_type)) return false;
  return std::ranges::all_of(field.tokens, [](std::string_view token) { return is_plain_word(token) || is_plain_text(token); });
}

void end_at(Node& node, std::size_t end) { node.span.length = end - node.span.offset; }

/// Block mappings span from their first key to the end of their last value.
void append(Node& mapping, text::Entry entry) {
  mapping.kind = NodeKind::kMapping;
  if (mapping.entries.empty()) mapping.span.offset = entry.key.span.offset;
  end_at(mapping, entry.value.span.end());
  mapping.entries.push_back(std::move(entry));
}

/// Finds the nodes of what was spelled, in its order. Between two tokens stand blanks, line breaks, brackets, commas and
/// dashes alone, so that each is met where it is next found.
class Places {
 public:
  Places(std::string_view bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  Node scalar(std::string_view token) {
    Node node;
    node.kind = NodeKind::kScalar;
    node.span = {find(token), token.size()};
    node.quoted = token.starts_with('"');
    node.value = node.quoted ? token.substr(1, token.size() - 2) : token;
    at_ = node.span.end();
    return node;
  }

  text::Entry entry(const Field& field) {
    Node key = scalar(field.key);
    return {std::move(key), value(field)};
  }

 private:
  Node value(const Field& field) {
    switch (field.shape) {
      case Shape::kScalar:
        return scalar(field.tokens.front());
      case Shape::kList:
        return list(field.tokens);
      case Shape::kRows:
        return rows(field);
      case Shape::kMatrix:
        return matrix(field);
    }
    return {};
  }

  [[nodiscard]] std::size_t find(std::string_view what) const { return bytes_.find(what, at_); }

  Node list(std::span<const std::string> tokens) {
    Node node;
    node.kind = NodeKind::kSequence;
    node.flow = true;
    node.span.offset = find("[");
    node.items.reserve(tokens.size());
    for (const std::string& token : tokens) node.items.push_back(scalar(token));
    at_ = find("]") + 1;
    end_at(node, at_);
    return node;
  }

  Node rows(const Field& field) {
    Node node;
    node.kind = NodeKind::kSequence;
    node.span.offset = find("-");
    const auto columns = static_cast<std::size_t>(std::max(1, field.columns));
    for (std::size_t i = 0; i < field.tokens.size(); i += columns)
      node.items.push_back(list(std::span(field.tokens).subspan(i, std::min(columns, field.tokens.size() - i))));
    end_at(node, at_);
    return node;
  }

  Node matrix(const Field& field) {
    Node node;
    const std::size_t tag = find("!!opencv-matrix");
    const int rows = static_cast<int>(field.tokens.size()) / std::max(1, field.columns);
    append(node, entry(fields::integer("rows", rows)));
    append(node, entry(fields::integer("cols", field.columns)));
    append(node, entry(fields::scalar("dt", field.element_type)));
    Node data = scalar("data");
    append(node, {std::move(data), list(field.tokens)});
    node.tag = "tag:yaml.org,2002:opencv-matrix";
    node.span.offset = tag;
    end_at(node, at_);
    return node;
  }

  std::string_view bytes_;
  std::size_t at_;
};

}  // namespace

void ComposedYaml::add_to(Node& mapping, const Field& field, std::size_t indentation) {
  const std::size_t begin = bytes_.size();
  bytes_ += fields::spell(field, indentation) + "\n";
  plain_ = plain_ && is_plain(field);
  if (plain_) append(mapping, Places(bytes_, begin).entry(field));
}

void ComposedYaml::add_mapping(const std::string& key, const std::vector<Field>& fields, std::size_t indentation) {
  const std::size_t begin = bytes_.size();
  bytes_ += key + ":\n";
  plain_ = plain_ && is_plain_key(key) && !fields.empty();
  Node name = Places(bytes_, begin).scalar(key);
  Node mapping;
  for (const Field& field : fields) add_to(mapping, field, indentation);
  append(root_, {std::move(name), std::move(mapping)});
}

std::optional<text::Document> ComposedYaml::document(std::string name, Diagnostics& diagnostics) && {
  // What has fewer bytes than a list may have values has no list that the parser refuses.
  const bool read = plain_ && !root_.entries.empty() && bytes_.size() <= text::kLongestList;
  text::Source source{std::move(name), std::move(bytes_)};
  if (!read) return text::parse_document(std::move(source), diagnostics);
  const text::Syntax syntax = source.bytes.starts_with("%YAML:") ? text::Syntax::kOpenCvYaml : text::Syntax::kYaml;
  return text::Document(std::move(source), syntax, std::move(root_));
}

}  // namespace fca
