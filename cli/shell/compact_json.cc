// SPDX-License-Identifier: BSD-3-Clause
#include "compact_json.h"

namespace fca::cli {

std::string compact(const std::string& document) {
  std::string line;
  line.reserve(document.size());
  bool in_text = false;
  for (std::size_t i = 0; i < document.size(); ++i) {
    const char c = document[i];
    if (c == '"') in_text = !in_text;
    if (in_text && c == '\\') {  // a quote behind it ends no text
      line += c;
      ++i;
    } else if (!in_text && (c == ' ' || c == '\n')) {
      continue;
    }
    line += document[i];
  }
  return line;
}

}  // namespace fca::cli
