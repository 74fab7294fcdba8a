// SPDX-License-Identifier: BSD-3-Clause
// Private: yaml-cpp reads the version of "%YAML 1.2" with a stream of the program's locale; where that writes decimal commas,
// or points between thousands, it takes "1.2" for no version and refuses the file.
#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace fca {

/// The text with the directive of a version 1.x in its first line made a comment, as long as it was. What yaml-cpp is to refuse
/// (another version, no "---" after) stays.
inline std::string without_version(std::string text) {
  constexpr std::string_view kDirective = "%YAML 1.";
  if (!text.starts_with(kDirective)) return text;
  std::size_t end = kDirective.size();
  while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
  const std::size_t line_end = text.find('\n', end);
  const bool alone = line_end != std::string::npos && text.find_first_not_of(" \t\r", end) == line_end;
  if (end > kDirective.size() && alone && text.compare(line_end + 1, 3, "---") == 0) text[0] = '#';
  return text;
}

}  // namespace fca
