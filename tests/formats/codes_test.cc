// SPDX-License-Identifier: BSD-3-Clause
// The table of codes: whole, in order, and every sentence can be said.
#include "message_samples.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>

#include <array>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace fca {
namespace {

std::array<std::string_view, 4> sentences_of_row(const CodeInfo& row) { return {row.text, row.why, row.consequence, row.fix}; }

std::vector<Argument> samples(const CodeInfo& row) {
  std::vector<Argument> arguments;
  for (const std::string_view sentence : sentences_of_row(row)) test::add_samples(sentence, arguments);
  return arguments;
}

TEST(Codes, EachHasOneRow) {
  std::set<Code> seen;
  for (const CodeInfo& row : all_codes()) {
    EXPECT_TRUE(seen.insert(row.code).second) << row.id << ": " << row.text;
    EXPECT_GT(row.code, Code::kNone);
    EXPECT_LT(row.code, Code::kCount);
    EXPECT_EQ(&info(row.code), &row);
  }
  EXPECT_EQ(seen.size() + 1, static_cast<std::size_t>(Code::kCount)) << "a code without a row";
  EXPECT_TRUE(info(Code::kNone).id.empty());
}

TEST(Codes, IdsAreKebabCase) {
  const std::regex kebab("[a-z0-9]+(-[a-z0-9]+)*");
  for (const CodeInfo& row : all_codes()) EXPECT_TRUE(std::regex_match(std::string(row.id), kebab)) << row.id;
}

TEST(Codes, EverySentenceCanBeSaid) {
  for (const CodeInfo& row : all_codes()) {
    EXPECT_FALSE(row.text.empty()) << row.id;
    const std::vector<Argument> arguments = samples(row);
    for (const std::string_view sentence : sentences_of_row(row)) {
      std::string said;
      EXPECT_NO_THROW(said = text::filled(sentence, arguments)) << sentence;
      EXPECT_EQ(said.empty(), sentence.empty()) << sentence;
    }
  }
}

TEST(Codes, NoSentenceNamesAnOption) {
  const std::regex option("(^|[ (,:;\"'])--[a-z]");
  for (const CodeInfo& row : all_codes()) {
    for (const std::string_view sentence : sentences_of_row(row))
      EXPECT_FALSE(std::regex_search(std::string(sentence), option)) << sentence;
  }
}

TEST(Messages, ArgumentsAreWrittenAsTheirPlaceSays) {
  const auto said = [](std::string_view pattern, const std::vector<Argument>& arguments) {
    return text::filled(pattern, arguments);
  };
  EXPECT_EQ(said("{0} {1}", {"cam0", 3}), "cam0 3");
  EXPECT_EQ(said("{0} {0:.3} {0:.2f} {0:real}", {1234.5678}), "1234.57 1.23e+03 1234.57 1234.5678");
  EXPECT_EQ(said("{0:real} {1:px} {2:px} {3:px} {4:%}", {2.0, 0.0, 0.1234, 4e-14, 0.125}), "2.0 0 0.123 4e-14 12.5 %");
  EXPECT_EQ(said("{0:rms}{1:worst}", {0.1234, 0.5}), "0.123 px rms off, worst 0.5");
  EXPECT_EQ(said("{0:rms}{1:worst}", {6e-14, 2.5e-13}), "exact");
  EXPECT_EQ(said("{0} key{0:s}, {1} key{1:s}", {1, 2}), "1 key, 2 keys");
  const std::vector<std::string> names = {"a", "b", "c"};
  EXPECT_EQ(said("{0:all} {1:all} {2:all}", {1.5, -1.0, 0.1}), "1.5 -1 0.1");
  EXPECT_EQ(said("{0}; {0:or}; {0:,}; name{0:s}", {names}), "a, b and c; a, b or c; a, b, c; names");
  EXPECT_EQ(said("{{}} {0}", {"x"}), "{} x");
  EXPECT_EQ(said("{0:_}{1}", {"cam0", "topic"}), "cam0 topic");
  EXPECT_EQ(said("{0:_}{1}", {"", "topic"}), "topic");
  EXPECT_ANY_THROW(said("{0:.3}", {"a name"}));
  EXPECT_ANY_THROW(said("{1}", {"alone"}));
}

TEST(Messages, ClausesStandOneBehindTheOther) {
  const Message clause{Code::kImuNoiseOfSamples, {200.0, 0.001}};
  const std::string alone = text::text_of(clause);
  EXPECT_EQ(text::filled("x{0}", std::vector<Argument>{clause}), "x" + alone);
  EXPECT_EQ(text::filled("x{0}", std::vector<Argument>{std::vector<Message>{clause, clause}}), "x" + alone + alone);
  EXPECT_EQ(text::filled("x{0}", std::vector<Argument>{std::vector<Message>()}), "x");
  EXPECT_EQ(text::filled("{0:or}", std::vector<Argument>{std::vector<Message>{clause, clause}}), alone + " or " + alone);
  EXPECT_EQ(text::filled("{0:then}", std::vector<Argument>{std::vector<Message>{clause, clause}}), alone + " then " + alone);
}

TEST(Messages, DiagnosticsTakeSeverityAndWordsFromTheTable) {
  Diagnostics diagnostics;
  diagnostics.add(Code::kLensCircleStretched, {"cam0"});
  diagnostics.add(Severity::kError, Code::kLensCircleStretched, {"cam1"});
  diagnostics.add(Diagnostic{Severity::kError, {Code::kImageSizeNotGiven, {"cam2"}}, {}, {Code::kTimeOffsetOfMilliseconds}});
  ASSERT_EQ(diagnostics.entries().size(), 3U);
  EXPECT_EQ(diagnostics.entries()[0].severity, Severity::kWarning);
  EXPECT_EQ(diagnostics.entries()[1].severity, Severity::kError);
  EXPECT_EQ(id_of(diagnostics.entries()[0]), "lens-circle-stretched");
  EXPECT_EQ(message_of(diagnostics.entries()[1]), text::text_of({Code::kLensCircleStretched, {"cam1"}}));
  // What fixes it, where its maker knows better: that row's fix, else its sentence.
  EXPECT_EQ(fix_of(diagnostics.entries()[2]), text::text_of({Code::kTimeOffsetOfMilliseconds}));
}

}  // namespace
}  // namespace fca
