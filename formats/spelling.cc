// SPDX-License-Identifier: BSD-3-Clause
#include "spelling.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace fca::fields {

using text::Node;
using text::Syntax;

namespace {

constexpr std::string_view kHex = "0123456789abcdef";

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

bool is_yaml(Syntax syntax) { return syntax == Syntax::kYaml || syntax == Syntax::kOpenCvYaml; }

bool is_number(const std::string& token) {
  const std::optional<double> value = text::parse_real(token);
  return value && std::isfinite(*value);
}

/// The text of a token: quote() undone.
std::string text_of(const std::string& token) {
  if (!token.starts_with('"')) return token;
  std::string text;
  for (std::size_t i = 1; i + 1 < token.size(); ++i) {
    if (token[i] != '\\') {
      text += token[i];
    } else if (token[i + 1] == 'x' && i + 3 < token.size()) {
      unsigned code = 0;
      std::from_chars(token.data() + i + 2, token.data() + i + 4, code, 16);
      text += static_cast<char>(code);
      i += 3;
    } else {
      text += token[++i];
    }
  }
  return text;
}

std::string json_string(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    if (is_control(c)) {
      text += "\\u00";
      text += kHex[static_cast<unsigned char>(c) >> 4];
      text += kHex[static_cast<unsigned char>(c) & 0xF];
    } else {
      text += c;
    }
  }
  return text + '"';
}

/// In single quotes, as Python itself prints it and mrcal's files have it.
std::string python_string(std::string_view value) {
  std::string text = "'";
  for (const char c : value) {
    if (c == '\'' || c == '\\') text += '\\';
    if (is_control(c)) {
      text += "\\x";
      text += kHex[static_cast<unsigned char>(c) >> 4];
      text += kHex[static_cast<unsigned char>(c) & 0xF];
    } else {
      text += c;
    }
  }
  return text + '\'';
}

/// A text in the syntax's quotes, of those that have brackets around everything.
std::string string_in(std::string_view value, Syntax syntax) {
  return syntax == Syntax::kPython ? python_string(value) : json_string(value);
}

/// cv::FileStorage wants entities for all five, quotes or not (4.6, persistence_xml.cpp).
std::string xml_string(std::string_view value) {
  constexpr std::pair<char, std::string_view> kEntities[] = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&apos;"}};
  std::string text = "\"";
  for (const char c : value) {
    const auto* entity = std::ranges::find(kEntities, c, &std::pair<char, std::string_view>::first);
    if (entity != std::end(kEntities)) {
      text += entity->second;
    } else if (is_control(c)) {
      text += "&#" + std::to_string(static_cast<int>(c)) + ";";
    } else {
      text += c;
    }
  }
  return text + '"';
}

/// A word that cv::FileStorage takes for text without quotes.
bool is_plain_word(std::string_view text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto plain = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && letter(text[0]) && std::ranges::all_of(text, plain);
}

std::string_view separator(Syntax syntax) { return syntax == Syntax::kXml || syntax == Syntax::kWords ? " " : ", "; }

std::string joined(std::span<const std::string> tokens, Syntax syntax) {
  std::string text;
  for (const std::string& token : tokens) {
    if (!text.empty()) text += separator(syntax);
    text += spell_token(token, syntax);
  }
  return text;
}

/// The tokens in rows of `columns`, each spelled by `row(numbers)`, with `between` two of them.
template <class F>
std::string in_rows(const Field& field, Syntax syntax, const std::string& between, F&& row) {
  std::string text;
  const auto columns = static_cast<std::size_t>(std::max(1, field.columns));
  for (std::size_t i = 0; i < field.tokens.size(); i += columns) {
    if (i > 0) text += between;
    text += row(joined(std::span(field.tokens).subspan(i, std::min(columns, field.tokens.size() - i)), syntax));
  }
  return text;
}

std::string as_is(const std::string& row) { return row; }
std::string in_brackets(const std::string& row) { return "[" + row + "]"; }

std::string row_count(const Field& field) {
  return std::to_string(static_cast<int>(field.tokens.size()) / std::max(1, field.columns));
}

/// The line break before a key of a matrix.
std::string break_before_key(const Style& style, std::size_t usual) {
  return "\n" + std::string(style.indentation > 0 ? style.indentation : usual, ' ');
}

std::string yaml_value(const Field& field, Syntax syntax, const Style& style) {
  switch (field.shape) {
    case Shape::kScalar:
      return " " + field.tokens.front();
    case Shape::kList:
      return " [" + joined(field.tokens, syntax) + "]";
    case Shape::kRows:
      return in_rows(field, syntax, "", [](const std::string& row) { return "\n  - [" + row + "]"; });
    case Shape::kMatrix: {
      const std::string next = break_before_key(style, 2);
      return " !!opencv-matrix" + next + "rows: " + row_count(field) + next + "cols: " + std::to_string(field.columns) + next +
             "dt: " + field.element_type + next + "data: [" + in_rows(field, syntax, "," + next + "       ", as_is) + "]";
    }
  }
  return "";
}

std::string yaml_flow_value(const Field& field, Syntax syntax) {
  switch (field.shape) {
    case Shape::kScalar:
    case Shape::kList:
      return yaml_value(field, syntax, {});
    case Shape::kRows:
      return " [" + in_rows(field, syntax, ", ", in_brackets) + "]";
    case Shape::kMatrix:
      return " !!opencv-matrix {rows: " + row_count(field) + ", cols: " + std::to_string(field.columns) +
             ", dt: " + field.element_type + ", data: [" + in_rows(field, syntax, ", ", as_is) + "]}";
  }
  return "";
}

/// JSON's and Python's.
std::string value_in_brackets(const Field& field, Syntax syntax, const Style& style) {
  const bool one_line = style.one_line;
  switch (field.shape) {
    case Shape::kScalar:
      return spell_token(field.tokens.front(), syntax);
    case Shape::kList:
      return "[" + joined(field.tokens, syntax) + "]";
    case Shape::kRows:
      if (one_line) return "[" + in_rows(field, syntax, ", ", in_brackets) + "]";
      return "[\n    " + in_rows(field, syntax, ",\n    ", in_brackets) + "\n]";
    case Shape::kMatrix: {
      const std::string line = one_line ? " " : break_before_key(style, 4);
      const std::string next = "," + line;
      const auto key = [syntax](std::string_view name) { return string_in(name, syntax) + ": "; };
      return std::string("{") + (one_line ? "" : line) + key("type_id") + string_in("opencv-matrix", syntax) + next +
             key("rows") + row_count(field) + next + key("cols") + std::to_string(field.columns) + next + key("dt") +
             string_in(field.element_type, syntax) + next + key("data") + "[" +
             in_rows(field, syntax, one_line ? ", " : next + "         ", as_is) + "]" + (one_line ? "}" : "\n}");
    }
  }
  return "";
}

std::string xml_element(const Field& field, const Style& style) {
  const bool one_line = style.one_line;
  const Syntax xml = Syntax::kXml;
  const std::string open = "<" + field.key + ">";
  const std::string close = "</" + field.key + ">";
  const std::string next = one_line ? "" : break_before_key(style, 2);
  const std::string last = one_line ? "" : "\n";
  switch (field.shape) {
    case Shape::kScalar:
    case Shape::kList:
      return open + joined(field.tokens, xml) + close;
    case Shape::kRows:
      return open + in_rows(field, xml, "", [&next](const std::string& row) { return next + "<_>" + row + "</_>"; }) + last +
             close;
    case Shape::kMatrix:
      return "<" + field.key + " type_id=\"opencv-matrix\">" + next + "<rows>" + row_count(field) + "</rows>" + next +
             "<cols>" + std::to_string(field.columns) + "</cols>" + next + "<dt>" + field.element_type + "</dt>" + next +
             "<data>" + (one_line ? "" : next + "  ") + in_rows(field, xml, one_line ? " " : next + "  ", as_is) + "</data>" +
             last + close;
  }
  return "";
}

}  // namespace

std::string quote(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (is_control(c)) {
      text += "\\x";
      text += kHex[static_cast<unsigned char>(c) >> 4];
      text += kHex[static_cast<unsigned char>(c) & 0xF];
    } else {
      text += c;
    }
  }
  return text + '"';
}

std::string spell_token(const std::string& token, Syntax syntax) {
  if (text::is_in_brackets(syntax)) {
    const bool is_python = syntax == Syntax::kPython;
    if (token == "true" || token == "false") return is_python ? (token == "true" ? "True" : "False") : token;
    if (is_number(token)) return token;
    // Neither knows another number.
    if (text::parse_real(token)) return is_python ? "None" : "null";
    return string_in(text_of(token), syntax);
  }
  if (syntax == Syntax::kXml) {
    const bool plain = !token.starts_with('"') && (text::parse_real(token) || is_plain_word(token));
    return plain ? token : xml_string(text_of(token));
  }
  return syntax == Syntax::kWords || syntax == Syntax::kBinary ? text_of(token) : token;
}

std::string spell_value(const Field& field, Syntax syntax, const Style& style) {
  switch (syntax) {
    case Syntax::kYaml:
    case Syntax::kOpenCvYaml:
      return style.one_line ? yaml_flow_value(field, syntax) : yaml_value(field, syntax, style);
    case Syntax::kJson:
    case Syntax::kPython:
      return value_in_brackets(field, syntax, style);
    case Syntax::kXml:
      return xml_element(field, style);
    case Syntax::kWords:
    case Syntax::kBinary:
      return joined(field.tokens, syntax);
  }
  return "";
}

std::string spell_entry(const Field& field, Syntax syntax, const Style& style) {
  const std::string value = spell_value(field, syntax, style);
  if (is_yaml(syntax)) return field.key + ":" + value;
  return text::is_in_brackets(syntax) ? string_in(field.key, syntax) + ": " + value : value;
}

bool says(const Node& node, const std::string& token, Syntax syntax) {
  if (!node.is_scalar()) return false;
  const bool token_quoted = token.starts_with('"');
  if (is_yaml(syntax)) {
    if (token_quoted) return node.quoted && quote(node.value) == token;
    if (node.quoted) return false;
  } else {
    // A text is one by its quotes in JSON and Python; in XML a word is one without them.
    const bool text_wanted = token_quoted || (!text::parse_real(token) && token != "true" && token != "false");
    const bool text_there = node.quoted || (!text::is_in_brackets(syntax) && !text::parse_real(node.value));
    if (text_wanted || text_there) return text_wanted == text_there && node.value == text_of(token);
  }
  if (node.value == token) return true;
  const std::optional<double> was = text::parse_real(node.value);
  const std::optional<double> is = text::parse_real(token);
  // An int where a real is wanted (or the reverse) is another type to the programs.
  const auto looks_real = [](std::string_view s) { return s.find_first_of(".eE") != std::string_view::npos; };
  return was && is && *was == *is && std::signbit(*was) == std::signbit(*is) && looks_real(node.value) == looks_real(token);
}

}  // namespace fca::fields
