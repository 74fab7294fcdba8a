// SPDX-License-Identifier: BSD-3-Clause
// The command's own words for codes: each can be said, and the library's row has the same arguments.
#include "shell/option_hints.h"

#include <fca/code.h>

#include <array>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fca::cli {
namespace {

constexpr std::array kParts = {text::Part::kText, text::Part::kWhy, text::Part::kConsequence, text::Part::kFix};

/// What {N:how} can write.
Argument sample(const std::string& how) {
  if (how == "s") return 2;
  if (how == "or" || how == "and" || how == ",") return std::vector<std::string>{"a", "b"};
  if (how == "short" || how == "_" || how == "shell" || how.empty()) return "name";
  return 0.125;
}

void add_samples(std::string_view sentence, std::vector<Argument>& arguments) {
  static const std::regex placeholder(R"(\{(\d+)(?::([^}]*))?\})");
  const std::string text(sentence);
  for (std::sregex_iterator match(text.begin(), text.end(), placeholder); match != std::sregex_iterator(); ++match) {
    const std::size_t index = std::stoul((*match)[1]);
    while (arguments.size() <= index) arguments.emplace_back("name");
    if ((*match)[2].length() > 0) arguments[index] = sample((*match)[2]);
  }
}

TEST(OptionHints, CanBeSaidWithTheArgumentsOfTheirRow) {
  std::size_t hints = 0;
  for (const CodeInfo& row : all_codes()) {
    for (const text::Part part : kParts) {
      const std::string_view words = with_options(row.code, part);
      if (words == text::table_wording(row.code, part)) continue;
      ++hints;
      std::vector<Argument> arguments;
      for (const text::Part each : kParts) add_samples(text::table_wording(row.code, each), arguments);
      add_samples(words, arguments);
      std::string said;
      EXPECT_NO_THROW(said = text::filled(words, arguments, with_options)) << words;
      EXPECT_FALSE(said.empty()) << words;
      EXPECT_FALSE(text::table_wording(row.code, part).empty()) << "the library says nothing where the command says: " << words;
    }
  }
  EXPECT_GT(hints, 100U);
}

TEST(OptionHints, OtherCodesAreSaidAsTheLibrarySaysThem) {
  EXPECT_EQ(with_options(Code::kImuRate, text::Part::kText), text::table_wording(Code::kImuRate, text::Part::kText));
}

}  // namespace
}  // namespace fca::cli
