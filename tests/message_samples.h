// SPDX-License-Identifier: BSD-3-Clause
// Arguments with which a sentence of the table can be said.
#pragma once

#include <fca/message.h>

#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace fca::test {

/// What {N:how} can write.
inline Argument sample(const std::string& how) {
  if (how == "s") return 2;
  if (how == "or" || how == "and" || how == "then" || how == ",") return std::vector<std::string>{"a", "b"};
  if (how == "short" || how == "_" || how == "shell" || how.empty()) return "name";
  return 0.125;
}

/// For the placeholders of a sentence; one that is written in two ways takes the special one.
inline void add_samples(std::string_view sentence, std::vector<Argument>& arguments) {
  static const std::regex placeholder(R"(\{(\d+)(?::([^}]*))?\})");
  const std::string text(sentence);
  for (std::sregex_iterator match(text.begin(), text.end(), placeholder); match != std::sregex_iterator(); ++match) {
    const std::size_t index = std::stoul((*match)[1]);
    while (arguments.size() <= index) arguments.emplace_back("name");
    if ((*match)[2].length() > 0) arguments[index] = sample((*match)[2]);
  }
}

}  // namespace fca::test
