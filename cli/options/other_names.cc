// SPDX-License-Identifier: BSD-3-Clause
#include "other_names.h"

#include <algorithm>

namespace fca::cli {

std::vector<std::string> in_usual_names(std::vector<std::string> words) {
  if (words.empty()) return words;
  if (words.front() == "help" && words.size() > 1) words = {words[1], "--help"};
  const auto* const found = std::ranges::find(kOtherNames, words.front(), &OtherName::typed);
  if (found != kOtherNames.end()) words.front() = found->meant;
  return words;
}

}  // namespace fca::cli
