// SPDX-License-Identifier: BSD-3-Clause
#include "ini_sections.h"

#include <utility>

namespace fca {

std::vector<IniLine> ini_lines_of(const text::Document& document) {
  std::vector<IniLine> lines;
  for (const text::Node& node : document.root().items) {
    if (node.items.empty()) continue;
    std::string text = document.source().bytes.substr(node.span.offset, node.span.length);
    if (text.starts_with('#') || text.starts_with(';')) continue;
    lines.push_back({&node, std::move(text)});
  }
  return lines;
}

bool is_ini_header(const IniLine& line) {
  return line.text.find('[') != std::string::npos && line.text.find(']') != std::string::npos;
}

std::vector<IniSection> ini_sections_of(const text::Document& document) {
  std::vector<IniSection> sections;
  for (IniLine& line : ini_lines_of(document)) {
    if (is_ini_header(line)) {
      sections.push_back({std::move(line), {}});
    } else if (!sections.empty()) {
      sections.back().lines.push_back(std::move(line));
    }
  }
  return sections;
}

}  // namespace fca
