// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/check.h>

#include <algorithm>

namespace fca {

std::span<const CodeInfo> check_codes() {
  // One after the other in the table of codes, by id.
  const std::span<const CodeInfo> rows = all_codes();
  return {std::ranges::lower_bound(rows, Code::kAnyA1NotZero, {}, &CodeInfo::code),
          std::ranges::upper_bound(rows, Code::kAnyYamlTab, {}, &CodeInfo::code)};
}

const CodeInfo* find_check_code(std::string_view id) {
  const std::span<const CodeInfo> codes = check_codes();
  const auto found = std::ranges::lower_bound(codes, id, {}, &CodeInfo::id);
  return found == codes.end() || found->id != id ? nullptr : &*found;
}

}  // namespace fca
