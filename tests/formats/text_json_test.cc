// SPDX-License-Identifier: BSD-3-Clause
// The tree of a JSON file, and what is said about one that is none.
#include "formats/text_checks.h"

#include <fca/code.h>
#include <fca/formats/text/dialect.h>

#include <opencv2/core/persistence.hpp>

namespace fca::test {
namespace {

using text::Document;
using text::NodeKind;
using text::Syntax;

constexpr const char* kSample = R"({
    "value0": {
        "intrinsics": [
            { "camera_type": "ds", "fx": 349.7560, "xi": -0.24e-1 },
            {}
        ],
        "resolution": [[752, 480], []],
        "a \"b\" \\ \u00e4\n": "x\/y",
        "yes": true, "no": false, "none": null
    },
    "K": {
        "type_id": "opencv-matrix",
        "rows": 1, "cols": 2, "dt": "d",
        "data": [ 1.0, 2.5000000000000000e+00 ]
    }
}
)";

Document json_of(const std::string& bytes) {
  Parsed parsed = parse(bytes, "file.json");
  EXPECT_TRUE(parsed.document) << parsed.rendered();
  if (!parsed.document) return {};
  EXPECT_EQ(parsed.document->syntax(), Syntax::kJson);
  return *std::move(parsed.document);
}

TEST(TextJson, TheTree) {
  const Document document = json_of(kSample);
  const auto spelled = [&document](const std::string& path) {
    return std::string(document.source().text(at(document, path).span));
  };
  EXPECT_TRUE(document.root().is_mapping());
  EXPECT_TRUE(document.root().flow);
  EXPECT_EQ(at(document, "value0/intrinsics/0/fx").value, "349.7560");
  EXPECT_FALSE(at(document, "value0/intrinsics/0/fx").quoted);
  EXPECT_EQ(spelled("value0/intrinsics/0/xi"), "-0.24e-1");
  EXPECT_TRUE(at(document, "value0/intrinsics/0/camera_type").quoted);
  EXPECT_EQ(spelled("value0/intrinsics/0/camera_type"), "\"ds\"");
  EXPECT_EQ(spelled("value0/intrinsics/0"), R"({ "camera_type": "ds", "fx": 349.7560, "xi": -0.24e-1 })");
  EXPECT_EQ(spelled("value0/intrinsics/1"), "{}");
  EXPECT_TRUE(at(document, "value0/intrinsics/1").is_mapping());
  EXPECT_EQ(spelled("value0/resolution"), "[[752, 480], []]");
  EXPECT_TRUE(at(document, "value0/resolution").flow);
  EXPECT_EQ(spelled("value0/resolution/1"), "[]");
  const text::Entry& odd = entry_at(at(document, "value0"), "a \"b\" \\ \xC3\xA4\n");
  EXPECT_EQ(document.source().text(odd.key.span), R"("a \"b\" \\ \u00e4\n")");
  EXPECT_TRUE(odd.key.quoted);
  EXPECT_EQ(odd.value.value, "x/y");
  EXPECT_TRUE(at(document, "value0/yes").is_scalar());
  EXPECT_EQ(spelled("value0/yes"), "true");
  EXPECT_EQ(at(document, "value0/no").value, "false");
  EXPECT_FALSE(at(document, "value0/no").quoted);
  EXPECT_EQ(at(document, "value0/none").kind, NodeKind::kNull);
  EXPECT_EQ(spelled("value0/none"), "null");
  EXPECT_EQ(at(document, "K").tag, "tag:yaml.org,2002:opencv-matrix");
  EXPECT_EQ(at(document, "K/type_id").value, "opencv-matrix");
  EXPECT_EQ(at(document, "value0").tag, "");
  EXPECT_EQ(document.bytes(), kSample);
  expect_nested_spans(document.root(), document.bytes().size());
}

TEST(TextJson, BomCrlfAndNoBlanks) {
  for (const char* bytes : {"\xEF\xBB\xBF{\r\n\"a\" :\t[1 ,-2.5E3]\r\n,\"\xC3\xA4\": {\"c\":\"\\\"\"}}\r\n", "{\"a\":[1,2]}"}) {
    const Document document = json_of(bytes);
    EXPECT_GE(expect_scalar_spans(document), 3);
    EXPECT_EQ(document.bytes(), bytes);
  }
  EXPECT_EQ(json_of("[1, [2]]").root().items.size(), 2U);
}

TEST(TextJson, DuplicateKeysAreKeptInOrder) {
  const Document document = json_of(R"({"a": 1, "b": 2, "a": 3})");
  ASSERT_EQ(document.root().entries.size(), 3U);
  EXPECT_EQ(document.root().entries[2].value.value, "3");
  // As cv::FileStorage does.
  EXPECT_EQ(text::find(document.root(), "a", text::Dialect::kOpenCv)->value, "1");
  const cv::FileStorage storage(document.bytes(), cv::FileStorage::READ | cv::FileStorage::MEMORY);
  EXPECT_EQ(static_cast<int>(storage["a"]), 1);
}

TEST(TextJson, WhatIsWrongAndWhere) {
  struct Row {
    const char* bytes;
    const char* place_and_code;
    Message facts;
  };
  const Row kRows[] = {
      {"{\"a\": 1,}", "1:8 json-syntax", {Code::kJsonCommaAfterLast}},
      {"{\n  \"a\": [1, 2,\n  ]\n}", "2:13 json-syntax", {Code::kJsonCommaAfterLast}},
      {"{\n  'a': 1\n}", "2:3 json-syntax", {Code::kJsonSingleQuotes}},
      {"{\"a\": 'b'}", "1:7 json-syntax", {Code::kJsonSingleQuotes}},
      {"{\"a\": NaN}", "1:7 json-syntax", {Code::kJsonNotANumber}},
      {"{\"a\": [1, .Nan]}", "1:11 json-syntax", {Code::kJsonNotANumber}},
      {"{\"a\": nan}", "1:7 json-syntax", {Code::kJsonNotANumber}},
      {"{\"a\": -Infinity}", "1:7 json-syntax", {Code::kJsonNotANumber}},
      {"{\"a\": 1} // c", "1:10 json-syntax", {Code::kJsonComment}},
      {"{\n# c\n\"a\": 1}", "2:1 json-syntax", {Code::kJsonComment}},
      {"{\"a\": 1}\n{\"b\": 2}", "2:1 json-syntax", {Code::kJsonAfterRoot}},
      {"{\"a\": 1}}", "1:9 json-syntax", {Code::kJsonAfterRoot}},
      {"{\"a\": [1, 2\n", "1:7 json-syntax", {Code::kJsonBracketOpen, {"["}}},
      {"{\"a\": {\"b\": 1}", "1:1 json-syntax", {Code::kJsonBracketOpen, {"{"}}},
      {"{\"a\": ", "1:1 json-syntax", {Code::kJsonBracketOpen, {"{"}}},
      {"{\"a\"", "1:1 json-syntax", {Code::kJsonBracketOpen, {"{"}}},
      {"{\"a\": \"b", "1:7 json-syntax", {Code::kJsonStringOpen}},
      {"{\"a\": \"b\n}", "1:7 json-syntax", {Code::kJsonStringOfLines}},
      {"{\"a\": \"b\tc\"}", "1:9 json-syntax", {Code::kJsonControlCharacter}},
      {"{\"a\": \"\\q\"}", "1:8 json-syntax", {Code::kJsonWrongEscape}},
      {"{\"a\": \"M\xFCnchen\"}", "1:9 json-syntax", {Code::kJsonNotUtf8}},
      {"{\"a\": 1 \"b\": 2}", "1:9 json-syntax", {Code::kJsonCommaMissing, {"}"}}},
      {"{\"a\": [1 2]}", "1:10 json-syntax", {Code::kJsonCommaMissing, {"]"}}},
      {"{\"a\" 1}", "1:6 json-syntax", {Code::kJsonColonMissing}},
      {"{a: 1}", "1:2 json-syntax", {Code::kJsonKeyWanted}},
      {"{\"a\": [1,,2]}", "1:10 json-syntax", {Code::kJsonValueMissing}},
      {"{\"a\": }", "1:7 json-syntax", {Code::kJsonValueMissing}},
      {"{\"a\": pinhole}", "1:7 json-syntax", {Code::kJsonNoValue, {"pinhole"}}},
      {"{\"a\": tru}", "1:7 json-syntax", {Code::kJsonNoValue, {"tru"}}},
      {"{\"a\": 017}", "1:7 json-syntax", {Code::kJsonLeadingZeros}},
      {"{\"a\": +5}", "1:7 json-syntax", {Code::kJsonPlus}},
      {"{\"a\": .5}", "1:7 json-syntax", {Code::kJsonPointFirst}},
      {"{\"a\": 5.}", "1:7 json-syntax", {Code::kJsonPointLast}},
      {"{\"a\": 1e}", "1:7 json-syntax", {Code::kJsonExponentEmpty}},
      {"{\"\xC3\xA4\xE2\x82\xAC\": x}", "1:8 json-syntax", {Code::kJsonNoValue, {"x"}}},
      {"\xEF\xBB\xBF{\"a\": x}", "1:7 json-syntax", {Code::kJsonNoValue, {"x"}}},
  };
  for (const Row& row : kRows) {
    EXPECT_EQ(place_and_code(row.bytes, "a.json"), row.place_and_code) << row.bytes;
    const Parsed parsed = parse(row.bytes, "a.json");
    EXPECT_EQ(parsed.diagnostics.entries().at(0).facts, row.facts) << row.bytes << "\n" << parsed.rendered();
  }
}

TEST(TextJson, NestingHasALimit) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_TRUE(parse(nested(text::kMaxDepth), "a.json").document);
  EXPECT_EQ(place_and_code(nested(text::kMaxDepth + 1), "a.json"), "1:65 too-deep");
  EXPECT_EQ(parse(nested(500'000), "a.json").codes(), "too-deep");
  EXPECT_EQ(parse(std::string(500'000, '['), "<stdin>").codes(), "too-deep");
}

TEST(TextJson, TruncationsAreHarmless) {
  expect_truncations_are_harmless(kSample, "a.json");
  expect_truncations_are_harmless(kSample, "a.yaml");
  expect_truncations_are_harmless(kSample, "<stdin>");
}

TEST(TextJson, ChangedBytesAreHarmless) {
  std::mt19937 random(7);
  const std::string kOdd = "{}[]\",:\\'\n\r\t 0-.eE+tfn/#\x80\xFF<";
  for (int i = 0; i < 5000; ++i) {
    std::string bytes = kSample;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = kOdd[random() % kOdd.size()];
    const Parsed parsed = parse(bytes, "a.json");
    if (parsed.document && parsed.document->syntax() == Syntax::kJson)
      expect_nested_spans(parsed.document->root(), bytes.size());
  }
}

TEST(TextJson, EditsStayInTheirPlace) {
  for (unsigned seed = 0; seed < 50; ++seed) expect_edits_stay_in_their_place(json_of(kSample), seed);
}

}  // namespace
}  // namespace fca::test
