// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/file_name.h>
#include <fca/formats/text/source.h>

#include <algorithm>

namespace fca {

std::string as_file_name(std::string_view name) {
  std::string result = text::valid_utf8(name);
  if (result.size() > kLongestFileName) {
    std::size_t end = kLongestFileName;
    while (end > 0 && (static_cast<unsigned char>(result[end]) & 0xC0U) == 0x80U) --end;  // whole characters
    result.resize(end);
  }
  // First, so that what a terminal would obey is a blank or '?' and no name of a folder.
  result = text::printable(result);
  std::ranges::replace_if(
      result, [](char c) { return c == '/' || c == '\\'; }, '_');
  return result.empty() || result.starts_with('.') ? "_" + result : result;
}

}  // namespace fca
