// SPDX-License-Identifier: BSD-3-Clause
// The command's own words for codes: each can be said, and the library's row has the same arguments.
#include "shell/option_hints.h"
#include "message_samples.h"

#include <fca/code.h>

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fca::cli {
namespace {

constexpr std::array kParts = {text::Part::kText, text::Part::kWhy, text::Part::kConsequence, text::Part::kFix};

TEST(OptionHints, CanBeSaidWithTheArgumentsOfTheirRow) {
  std::size_t hints = 0;
  for (const CodeInfo& row : all_codes()) {
    for (const text::Part part : kParts) {
      const std::string_view words = with_options(row.code, part);
      if (words == text::table_wording(row.code, part)) continue;
      ++hints;
      std::vector<Argument> arguments;
      for (const text::Part each : kParts) test::add_samples(text::table_wording(row.code, each), arguments);
      test::add_samples(words, arguments);
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
