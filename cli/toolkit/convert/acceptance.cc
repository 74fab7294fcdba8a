// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/toolkit/acceptance.h>

#include <algorithm>

namespace fca {

TypedAcceptance parse_acceptance(std::string_view word) {
  const std::size_t colon = std::min(word.find(':'), word.size());
  TypedAcceptance typed{std::string(word.substr(0, colon))};
  const CodeInfo* const row = find_code(typed.id);
  if (row != nullptr) typed.acceptance = {row->code, std::string(word.substr(std::min(colon + 1, word.size())))};
  return typed;
}

}  // namespace fca
