// SPDX-License-Identifier: BSD-3-Clause
// Lines of words: every physical line is an item, whatever stands on it.
#include "formats/text_checks.h"
#include "text/words.h"

namespace fca::test {
namespace {

using text::Document;
using text::Syntax;

constexpr const char* kOcam =
    "#polynomial coefficients\n\n5 -2.5e+02 0.000000e+00 1.5e-03 -3.0e-06 1.0e-08 \n\n  # inverse\n\n2\t379.25 229.5\n";

Document words_of(const std::string& bytes) {
  Parsed parsed = parse(bytes, "calib_results.txt");
  EXPECT_TRUE(parsed.document) << parsed.rendered();
  EXPECT_EQ(parsed.document->syntax(), Syntax::kWords);
  return *std::move(parsed.document);
}

TEST(TextWords, EveryLineIsAnItem) {
  const Document document = words_of(kOcam);
  const text::Node& root = document.root();
  ASSERT_TRUE(root.is_sequence());
  ASSERT_EQ(root.items.size(), 7U);
  EXPECT_EQ(root.items[0].tag, text::kCommentTag);
  EXPECT_EQ(document.source().text(root.items[0].span), "#polynomial coefficients");
  EXPECT_TRUE(root.items[1].is_sequence());
  EXPECT_TRUE(root.items[1].items.empty());
  EXPECT_TRUE(root.items[1].tag.empty());
  EXPECT_EQ(document.source().position(root.items[1].span.offset).line, 2);
  EXPECT_EQ(root.items[2].items.size(), 6U);
  EXPECT_EQ(root.items[2].items[1].value, "-2.5e+02");
  EXPECT_EQ(root.items[4].tag, text::kCommentTag);
  EXPECT_EQ(root.items[4].items.size(), 2U);
  EXPECT_EQ(root.items[6].items.size(), 3U);
  EXPECT_EQ(document.source().text(root.items[6].span), "2\t379.25 229.5");
  EXPECT_EQ(expect_scalar_spans(document), 2 + 6 + 2 + 3);
  EXPECT_EQ(document.bytes(), kOcam);
}

TEST(TextWords, LineBreaksOfAllKindsAndNone) {
  const Document crlf = words_of("\xEF\xBB\xBFPinhole 1.5 2 3 4 0\r\n512 512\r\n\r\ncrop");
  ASSERT_EQ(crlf.root().items.size(), 4U);
  EXPECT_EQ(at(crlf, "0/0").value, "Pinhole");
  EXPECT_EQ(at(crlf, "0/0").span.offset, 3U);
  EXPECT_EQ(at(crlf, "1/1").value, "512");
  EXPECT_EQ(at(crlf, "3/0").value, "crop");
  EXPECT_EQ(expect_scalar_spans(crlf), 9);
}

TEST(TextWords, DsoAndFlatFiles) {
  EXPECT_EQ(at(words_of("0.5 0.6 0.5 0.5 0.9\n640 480\nfull\n640 480"), "0/4").value, "0.9");
  EXPECT_EQ(words_of("640 480 -69.5 0.0 5.5e-4\n").root().items.size(), 1U);
}

TEST(TextWords, EditsStayInTheirPlace) {
  for (unsigned seed = 0; seed < 50; ++seed) expect_edits_stay_in_their_place(words_of(kOcam), seed);
}

TEST(TextWords, TruncationsAreHarmless) { expect_truncations_are_harmless(kOcam, "calib_results.txt"); }

}  // namespace
}  // namespace fca::test
