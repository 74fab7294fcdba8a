// SPDX-License-Identifier: BSD-3-Clause
// Names as people and files spell them: "Kannala-Brandt", "kannala_brandt" and "KannalaBrandt" are one.
#pragma once

#include <string>
#include <string_view>

namespace fca {

/// Lower case (of ASCII), without '-' and '_'.
[[nodiscard]] inline std::string normalised_id(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c != '-' && c != '_') result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

}  // namespace fca
