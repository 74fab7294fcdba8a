// SPDX-License-Identifier: BSD-3-Clause
#include "storage_limits.h"

#include <algorithm>

namespace fca::consumers::storage {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;
constexpr int kMaxDepth = 64;
constexpr int kMaxOpenings = 512;
constexpr std::size_t kMaxIndent = 200;

/// YAML and JSON. Counts brackets without looking at quotes and comments: it may refuse a strange file, but it cannot be talked
/// out of it. JSON nests by brackets only, so there the "- " and ": " of a line say nothing.
bool is_nested_too_deep(std::string_view text, bool is_json) {
  int depth = 0;
  int openings = 0;
  std::size_t column = 0;
  bool at_indent = true;
  int indicators = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    column = c == '\n' ? 0 : column + 1;
    if (c == '\n') indicators = 0;
    at_indent = c == '\n' || (at_indent && c == ' ');
    if (at_indent && column > kMaxIndent && !is_json) return true;
    if (c == '[' || c == '{') {
      ++depth;
      ++openings;
    }
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (!is_json && (c == '-' || c == ':') && i + 1 < text.size() && text[i + 1] == ' ') ++indicators;
    if (depth > kMaxDepth || openings > kMaxOpenings || indicators > kMaxDepth) return true;
  }
  return false;
}

/// XML. Elements in comments count, too, for the same reason; what is left open or opened in all is bounded.
bool has_too_many_elements(std::string_view text) {
  int depth = 0;
  int openings = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != '<') continue;
    const char next = text[i + 1];
    if (next == '/') {
      if (depth > 0) --depth;
    } else if (next != '!' && next != '?') {
      ++depth;
      ++openings;
    }
    if (depth > kMaxDepth || openings > kMaxOpenings) return true;
  }
  return false;
}

}  // namespace

std::string find_obstacle(std::string_view bytes) {
  if (bytes.empty()) return "the file is empty";
  if (bytes.size() > kMaxBytes) return "the file is larger than 2 MiB; not read";
  if (bytes.find('\0') != std::string_view::npos) return "the file contains a zero byte: it is not text";
  constexpr std::string_view kBlanksAndBom = " \t\r\n\xEF\xBB\xBF";
  const std::size_t first = bytes.find_first_not_of(kBlanksAndBom);
  const std::string_view head = first == std::string_view::npos ? std::string_view() : bytes.substr(first);
  if (head.starts_with("<")) {
    return has_too_many_elements(bytes) ? "more than 64 nested or 512 elements; not read" : std::string();
  }
  if (is_nested_too_deep(bytes, head.starts_with("{")))
    return "more than 64 nested lists or maps, or an indentation beyond 200";
  return {};
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

}  // namespace fca::consumers::storage
