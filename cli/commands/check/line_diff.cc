// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace fca::cli {

namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string marked(char mark, std::string_view line) { return std::string(1, mark) + " " + std::string(line) + "\n"; }

}  // namespace

// Fixes replace spellings within lines and add a line or two: walking both texts in step, and looking a few lines ahead where
// they differ, finds them all.
std::string line_diff(std::string_view before, std::string_view after) {
  const std::vector<std::string_view> a = lines_of(before);
  const std::vector<std::string_view> b = lines_of(after);
  std::string text;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      ++i;
      ++j;
      continue;
    }
    text += "@ line " + std::to_string(i + 1) + "\n";
    const std::size_t added = b.size() - j > a.size() - i ? (b.size() - j) - (a.size() - i) : 0;
    if (i < a.size()) text += marked('-', a[i++]);
    if (j < b.size()) text += marked('+', b[j++]);
    for (std::size_t k = 0; k < added && j < b.size() && (i >= a.size() || b[j] != a[i]); ++k) text += marked('+', b[j++]);
  }
  return text;
}

}  // namespace fca::cli
