// SPDX-License-Identifier: BSD-3-Clause
#include "opencv_prepass.h"

#include <algorithm>

namespace fca::text {

namespace {

bool is_key_character(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-';
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Length of the line's head up to and with the colon of a block key that lacks its blank; 0 if there is none.
std::size_t tight_key(std::string_view line) {
  std::size_t at = 0;
  while (at < line.size() && (line[at] == ' ' || (line[at] == '-' && at + 1 < line.size() && line[at + 1] == ' '))) ++at;
  const std::size_t key = at;
  while (at < line.size() && is_key_character(line[at])) ++at;
  const bool colon = at > key && at < line.size() && line[at] == ':';
  if (!colon || at + 1 >= line.size() || is_blank(line[at + 1])) return 0;
  return at + 1;
}

/// Depth of open flow brackets after this line; quotes end on their line in OpenCV's dialect.
int flow_depth_after(std::string_view line, int depth) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != '\0') {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#' && (i == 0 || is_blank(line[i - 1]))) {
      break;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      depth = std::max(0, depth - 1);
    }
  }
  return depth;
}

}  // namespace

std::size_t SpacedText::original_offset(std::size_t offset) const {
  const auto before = std::ranges::lower_bound(insertions, offset) - insertions.begin();
  return offset - static_cast<std::size_t>(before);
}

SpacedText space_after_keys(std::string_view bytes) {
  SpacedText result;
  result.text.reserve(bytes.size() + 64);
  int depth = 0;
  for (std::size_t start = 0; start < bytes.size();) {
    const std::size_t newline = bytes.find('\n', start);
    const std::size_t end = newline == std::string_view::npos ? bytes.size() : newline + 1;
    const std::string_view line = bytes.substr(start, end - start);
    const std::size_t head = depth == 0 && !line.starts_with('%') ? tight_key(line.substr(0, line.find('\n'))) : 0;
    result.text += line.substr(0, head);
    if (head > 0) {
      result.insertions.push_back(result.text.size());
      result.text += ' ';
    }
    result.text += line.substr(head);
    depth = flow_depth_after(line, depth);
    start = end;
  }
  return result;
}

}  // namespace fca::text
