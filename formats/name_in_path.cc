// SPDX-License-Identifier: BSD-3-Clause
#include "name_in_path.h"

#include <algorithm>
#include <filesystem>

namespace fca {

std::string indexed_name(std::string_view text, std::string_view prefix) {
  constexpr std::string_view kDigits = "0123456789";
  for (std::size_t at = text.rfind(prefix); at != std::string_view::npos; at = at == 0 ? at - 1 : text.rfind(prefix, at - 1)) {
    const std::size_t digits = at + prefix.size();
    const std::size_t end = std::min(text.find_first_not_of(kDigits, digits), text.size());
    constexpr std::size_t kMostDigits = 4;
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const bool in_a_word = (at > 0 && is_letter(text[at - 1])) || (end < text.size() && is_letter(text[end]));
    if (end > digits && end - digits <= kMostDigits && !in_a_word) return std::string(text.substr(at, end - at));
  }
  return "";
}

std::string name_by_path(std::string_view path, std::string_view prefix) {
  const std::filesystem::path file = path;
  const std::string own = indexed_name(file.stem().string(), prefix);
  return own.empty() ? indexed_name(file.parent_path().filename().string(), prefix) : own;
}

}  // namespace fca
