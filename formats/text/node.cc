// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/node.h>

namespace fca::text {

std::string in_one_line(const Node& node) {
  std::string line;
  if (node.is_sequence()) {
    for (const Node& item : node.items) line += (line.empty() ? "" : ", ") + in_one_line(item);
    return "[" + line + "]";
  }
  if (node.is_mapping()) {
    for (const Entry& entry : node.entries)
      line += (line.empty() ? "" : ", ") + entry.key.value + ": " + in_one_line(entry.value);
    return "{" + line + "}";
  }
  return node.value;
}

}  // namespace fca::text
