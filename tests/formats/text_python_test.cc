// SPDX-License-Identifier: BSD-3-Clause
// The tree of a literal of Python, what is said about one that is none, and edits of it.
#include "fields.h"
#include "formats/text_checks.h"
#include "text/comments.h"
#include "text/python.h"

#include <fca/code.h>
#include <fca/formats/text/top_comment.h>

namespace fca::test {
namespace {

using fields::Field;
using text::Dialect;
using text::Document;
using text::NodeKind;
using text::Syntax;

constexpr const char* kSample = R"(# generated on 2026-01-02 { [ '
{
    'lensmodel':  'LENSMODEL_OPENCV4', # not '}'

    # fx, fy, ...
    "intrinsics": [ 1.5, -2e-2, .5, 3.,],
    'tuple': (1, (2,), (3), ()),
    'region': [
    [ 0, 634 ],# no blank before
    [ +5, 00 ],
],
    'text': 'a\'b"\\\x41\u00e4\n' "c" # in the midst
            '''d
e''',
    'raw': r'\d', 'words': [True, False, None],
    'blob': b'{"#}]\'\\x41;' b"'<",
}
)";

Document python_of(const std::string& bytes) {
  Parsed parsed = parse(bytes, "file.cameramodel");
  EXPECT_TRUE(parsed.document) << parsed.rendered();
  if (!parsed.document) return {};
  EXPECT_EQ(parsed.document->syntax(), Syntax::kPython);
  return *std::move(parsed.document);
}

TEST(TextPython, TheTree) {
  const Document document = python_of(kSample);
  const auto spelled = [&document](const std::string& path) {
    return std::string(document.source().text(at(document, path).span));
  };
  EXPECT_TRUE(document.root().is_mapping());
  EXPECT_TRUE(document.root().flow);
  EXPECT_EQ(at(document, "lensmodel").value, "LENSMODEL_OPENCV4");
  EXPECT_TRUE(at(document, "lensmodel").quoted);
  EXPECT_EQ(spelled("intrinsics"), "[ 1.5, -2e-2, .5, 3.,]");
  EXPECT_EQ(at(document, "intrinsics").items.size(), 4U);
  EXPECT_EQ(at(document, "intrinsics/1").value, "-2e-2");
  EXPECT_FALSE(at(document, "intrinsics/1").quoted);
  EXPECT_EQ(spelled("intrinsics/3"), "3.");
  EXPECT_EQ(at(document, "tuple").items.size(), 4U);
  EXPECT_EQ(spelled("tuple/1"), "(2,)");
  EXPECT_EQ(spelled("tuple/2"), "3") << "brackets around a value are no tuple";
  EXPECT_TRUE(at(document, "tuple/3").is_sequence());
  EXPECT_EQ(spelled("region/1/0"), "+5");
  EXPECT_EQ(at(document, "text").value, "a'b\"\\A\xC3\xA4\ncd\ne");
  EXPECT_EQ(at(document, "text").tag, "");
  EXPECT_EQ(at(document, "raw").value, "\\d");
  EXPECT_EQ(at(document, "words/0").value, "true");
  EXPECT_EQ(at(document, "words/1").value, "false");
  EXPECT_FALSE(at(document, "words/1").quoted);
  EXPECT_EQ(at(document, "words/2").kind, NodeKind::kNull);
  EXPECT_EQ(at(document, "blob").value, "{\"#}]\\'\\\\x41;'<");
  EXPECT_EQ(at(document, "blob").tag, text::kBytesTag);
  EXPECT_EQ(spelled("blob"), "b'{\"#}]\\'\\\\x41;' b\"'<\"");
  EXPECT_EQ(document.bytes(), kSample);
  expect_nested_spans(document.root(), document.bytes().size());
  EXPECT_EQ(expect_scalar_spans(document), 25);
}

TEST(TextPython, BomCrlfAndNoBlanks) {
  for (const char* bytes :
       {"\xEF\xBB\xBF{\r\n'a' :\t[1 ,-2.5E3,]\r\n,'\xC3\xA4': {'c':''}}\r\n", "{'a':[1,2]}", "#\r{'a':\r1}"})
    EXPECT_EQ(python_of(bytes).bytes(), bytes);
  EXPECT_EQ(python_of("[1, (2,)]").root().items.size(), 2U);
  EXPECT_EQ(python_of("{}").root().entries.size(), 0U);
}

TEST(TextPython, OfDuplicateKeysTheLastCounts) {
  const Document document = python_of("{'a': 1, 'b': 2, 'a': 3}");
  ASSERT_EQ(document.root().entries.size(), 3U);
  EXPECT_EQ(text::find(document.root(), "a", Dialect::kPyYaml)->value, "3");
}

TEST(TextPython, YamlThatBeginsAlikeStaysYaml) {
  EXPECT_EQ(parse("{'a': [x, y]}", "a").document->syntax(), Syntax::kYaml);
  EXPECT_EQ(parse("{'a': 1}", "a").document->syntax(), Syntax::kPython);
  EXPECT_EQ(parse("{'a': 1}", "a.yaml").document->syntax(), Syntax::kYaml);
  EXPECT_EQ(place_and_code("{'a': [x, y]}", "a.cameramodel"), "1:8 python-syntax");
}

TEST(TextPython, WhatIsWrongAndWhere) {
  struct Row {
    const char* bytes;
    const char* place_and_code;
    Message facts;
  };
  const Row kRows[] = {
      {"{'a': nan}", "1:7 python-syntax", {Code::kLiteralNotANumber}},
      {"{'a': -inf}", "1:7 python-syntax", {Code::kLiteralNotANumber}},
      {"{'a': 1}\n{'b': 2}", "2:1 python-syntax", {Code::kLiteralAfterRoot}},
      {"{'a': 1},", "1:9 python-syntax", {Code::kLiteralAfterRoot}},
      {"{'a': [1, 2\n", "1:7 python-syntax", {Code::kLiteralBracketOpen, {"["}}},
      {"{'a': {'b': 1} # }", "1:1 python-syntax", {Code::kLiteralBracketOpen, {"{"}}},
      {"{'a': ", "1:1 python-syntax", {Code::kLiteralBracketOpen, {"{"}}},
      {"{'a'", "1:1 python-syntax", {Code::kLiteralBracketOpen, {"{"}}},
      {"# nothing\n", "1:10 python-syntax", {Code::kLiteralEndsEarly}},
      {"{'a': 'b", "1:7 python-syntax", {Code::kLiteralStringOpen}},
      {"{'a': '''b\n}", "1:7 python-syntax", {Code::kLiteralStringOpen}},
      {"{'a': b'b\n'}", "1:7 python-syntax", {Code::kLiteralStringOfLines}},
      {"{'a': 'b'\n  b'c'}", "2:3 python-syntax", {Code::kLiteralStringsMixed}},
      {"{'a': '\\x4'}", "1:8 python-syntax", {Code::kLiteralWrongEscape}},
      {"{'a': '\\ud800'}", "1:8 python-syntax", {Code::kLiteralWrongEscape}},
      {"{'a': 'M\xFCnchen'}", "1:9 python-syntax", {Code::kLiteralNotUtf8}},
      {"{'a': 1 'b': 2}", "1:9 python-syntax", {Code::kLiteralCommaMissing, {"}"}}},
      {"{'a': [1 2]}", "1:10 python-syntax", {Code::kLiteralCommaMissing, {"]"}}},
      {"{'a': [1)}", "1:9 python-syntax", {Code::kLiteralCommaMissing, {"]"}}},
      {"{'a': (1, 2]}", "1:12 python-syntax", {Code::kLiteralCommaMissing, {")"}}},
      {"{'a': (1, ]}", "1:11 python-syntax", {Code::kLiteralValueMissing}},
      {"{'a' 1}", "1:6 python-syntax", {Code::kLiteralColonMissing}},
      {"{'a', 'b'}", "1:5 python-syntax", {Code::kLiteralColonMissing}},
      {"{a: 1}", "1:2 python-syntax", {Code::kLiteralKeyWanted}},
      {"{1: 1}", "1:2 python-syntax", {Code::kLiteralKeyWanted}},
      {"{'a': [1,,2]}", "1:10 python-syntax", {Code::kLiteralValueMissing}},
      {"{'a': }", "1:7 python-syntax", {Code::kLiteralValueMissing}},
      {"{'a': pinhole}", "1:7 python-syntax", {Code::kLiteralNoValue, {"pinhole"}}},
      {"{'a': true}", "1:7 python-syntax", {Code::kLiteralNoValue, {"true"}}},
      {"{'a': np.array([1])}", "1:7 python-syntax", {Code::kLiteralNoValue, {"np.array"}}},
      {"{'a': f'b'}", "1:7 python-syntax", {Code::kLiteralNoValue, {"f"}}},
      {"{'a': 017}", "1:7 python-syntax", {Code::kLiteralNoNumber, {"017"}}},
      {"{'a': 0x1F}", "1:7 python-syntax", {Code::kLiteralNoNumber, {"0x1F"}}},
      {"{'a': 1+2j}", "1:7 python-syntax", {Code::kLiteralNoNumber, {"1+2j"}}},
      {"{'a': 1e}", "1:7 python-syntax", {Code::kLiteralNoNumber, {"1e"}}},
      {"{'a': .}", "1:7 python-syntax", {Code::kLiteralNoNumber, {"."}}},
      {"{'a': --1}", "1:7 python-syntax", {Code::kLiteralNoNumber, {"--1"}}},
      {"{\n<<<<<<< HEAD\n'a': 1}", "2:1 merge-conflict", {Code::kMergeConflict}},
  };
  for (const Row& row : kRows) {
    EXPECT_EQ(place_and_code(row.bytes, "a.cameramodel"), row.place_and_code) << row.bytes;
    const Parsed parsed = parse(row.bytes, "a.cameramodel");
    ASSERT_FALSE(parsed.diagnostics.entries().empty()) << row.bytes;
    EXPECT_EQ(parsed.diagnostics.entries().at(0).facts, row.facts) << row.bytes << "\n" << parsed.rendered();
  }
}

TEST(TextPython, NestingAndListsHaveALimit) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_TRUE(parse(nested(text::kMaxDepth), "a.cameramodel").document);
  EXPECT_EQ(place_and_code(nested(text::kMaxDepth + 1), "a.cameramodel"), "1:65 too-deep");
  EXPECT_EQ(parse(std::string(500'000, '('), "a.cameramodel").codes(), "too-deep");
  std::string list = "[";
  for (int i = 0; i <= 100'000; ++i) list += "1,";
  EXPECT_EQ(parse(list + "]", "a.cameramodel").codes(), "too-long");
}

TEST(TextPython, TruncationsAreHarmless) {
  expect_truncations_are_harmless(kSample, "a.cameramodel");
  expect_truncations_are_harmless(kSample, "<stdin>");
}

TEST(TextPython, ChangedBytesAreHarmless) {
  std::mt19937 random(7);
  const std::string kOdd = "{}[]()\",:\\'\n\r\t 0-.eE+tfnbrux/#\x80\xFF<";
  for (int i = 0; i < 5000; ++i) {
    std::string bytes = kSample;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = kOdd[random() % kOdd.size()];
    const Parsed parsed = parse(bytes, "a.cameramodel");
    if (parsed.document) expect_nested_spans(parsed.document->root(), bytes.size());
  }
}

TEST(TextPython, EditsStayInTheirPlace) {
  for (unsigned seed = 0; seed < 50; ++seed) expect_edits_stay_in_their_place(python_of(kSample), seed);
}

// But for one between strings that are one: it is inside a scalar.
TEST(TextPython, CommentsAreFound) {
  const Document document = python_of(kSample);
  std::vector<std::string> comments;
  for (const text::Span& span : text::comments_of(document)) comments.emplace_back(document.source().text(span));
  EXPECT_EQ(comments,
            (std::vector<std::string>{"# generated on 2026-01-02 { [ '", "# not '}'", "# fx, fy, ...", "# no blank before"}));
  Document commented = document;
  const std::vector<std::string> lines = {"Written by fca-io"};
  ASSERT_TRUE(text::add_top_comment(commented, lines));
  EXPECT_EQ(commented.bytes().find("# generated on 2026-01-02 { [ '\n# Written by fca-io\n{"), 0U) << commented.bytes();
}

// Whatever goes, what is left is a literal of the keys that stay; a comma after the last one included.
TEST(TextPython, AnySubsetOfEntriesMayGo) {
  for (const char* bytes :
       {"{\n    'a': 1,\n    'b': [1, 2],\n    'c': 'x',\n}\n", "{'a': 1, 'b': 2, 'c': 3}", "{'a':1,'b':2,'c':3,}"}) {
    for (unsigned mask = 0; mask < 8; ++mask) {
      Document document = python_of(bytes);
      std::string rest;
      for (std::size_t i = 0; i < 3; ++i) {
        if ((mask >> i & 1U) != 0)
          document.remove_entry(document.root(), document.root().entries[i]);
        else
          rest += document.root().entries[i].key.value;
      }
      std::string keys;
      const Document left = python_of(document.bytes());
      for (const text::Entry& entry : left.root().entries) keys += entry.key.value;
      EXPECT_EQ(keys, rest) << document.bytes();
    }
  }
}

TEST(TextPython, FieldsAreSpelledAsPythonSpellsThem) {
  Document document = python_of("{\n    'a': 1.50, # one\n    'name': 'x',\n}\n");
  const std::vector<Field> before = {fields::real("a", 1.5), fields::quoted("name", "x")};
  const std::vector<Field> after = {fields::real("a", -2e-5), fields::quoted("name", "it's \\"),
                                    fields::list("D", std::vector{1.0, 2.0}), fields::scalar("flag", "true")};
  fields::apply(document, document.root(), Dialect::kPyYaml, before, after);
  EXPECT_EQ(document.bytes(),
            "{\n    'a': -2.0e-05, # one\n    'name': 'it\\'s \\\\',\n    'D': [1.0, 2.0],\n    'flag': True,\n}\n");
  const Document again = python_of(document.bytes());
  EXPECT_EQ(at(again, "name").value, "it's \\");
  EXPECT_EQ(at(again, "flag").value, "true");
  Document same = again;
  fields::apply(same, same.root(), Dialect::kPyYaml, {}, after);
  EXPECT_FALSE(same.edited()) << same.bytes();
}

}  // namespace
}  // namespace fca::test
