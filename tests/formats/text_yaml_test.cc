// SPDX-License-Identifier: BSD-3-Clause
// The tree of a YAML file: spans that are exactly the bytes of a value, and a diagnostic with its place for what is no
// calibration.
#include "formats/text_checks.h"
#include "text/opencv_prepass.h"

#include <fca/code.h>

namespace fca::test {
namespace {

using text::Document;
using text::Node;

/// The bytes at a plain scalar's span are its value; those of a quoted one begin and end with the quote.
void expect_spans(const std::string& bytes) {
  const Document document = document_of(bytes);
  std::size_t behind = 0;
  for (const Node* scalar : scalars_of(document)) {
    const std::string spelled(document.source().text(scalar->span));
    ASSERT_GE(scalar->span.offset, behind) << spelled;
    behind = scalar->span.end();
    if (scalar->quoted) {
      ASSERT_GE(spelled.size(), 2U);
      EXPECT_EQ(spelled.front(), spelled.back());
      EXPECT_TRUE(spelled.front() == '"' || spelled.front() == '\'') << spelled;
    } else {
      EXPECT_EQ(spelled, scalar->value);
    }
  }
  EXPECT_GT(behind, 0U);
}

TEST(TextYaml, SpansAreTheValuesBytesInEveryGoodFile) {
  int files = 0;
  for (const fs::path& path : files_of_all_formats("good")) {
    if (path.extension() != ".yaml" && path.extension() != ".yml") continue;
    SCOPED_TRACE(path);
    expect_spans(read_file(path));
    ++files;
  }
  EXPECT_GE(files, 10);
}

TEST(TextYaml, SpansAreTheValuesBytesInTheCorpus) {
  if (!fs::exists(shared_dir() / "corpus")) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  int parsed = 0;
  for (const char* format : {"kalibr", "orbslam3"}) {
    for (const fs::path& path : files_in(shared_dir() / "corpus" / format)) {
      const std::string bytes = read_file(path);
      if (!parse(bytes).document) continue;
      SCOPED_TRACE(path);
      expect_spans(bytes);
      ++parsed;
    }
  }
  EXPECT_GT(parsed, 150);
}

TEST(TextYaml, SpansSurviveCrlfBomAndUtf8) {
  expect_spans("a: 1.5\r\nb: [2.5, x]\r\nc:\r\n  - d: 4\r\n    e: 'f'\r\n");
  expect_spans(
      "\xEF\xBB\xBF"
      "a: 1.5\nb: 2\n");
  expect_spans("# \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x93\xB7\na: 1.5 # \xC3\xBC\nb: [\"\xC3\xA4\", 3, 4]\n");
  expect_spans("\xEF\xBB\xBF# \xC3\xA9\r\na: 1.5 # \xC3\xBC\r\nb: 7\r\n");
  // Latin-1, a cut sequence, an overlong one and a lone continuation: bad bytes count one each, as in the file.
  expect_spans("# M\xFCnchen \xE2\x82 \xC0\x80 \x80\na: 1.5 # \xB0\nb: 7\n");
}

TEST(TextYaml, SpansOfCollectionsAreTheirBytes) {
  const Document document = document_of(
      "a: [1, [2, 3], \"]\"] # ]\nb:\n  - 1\n  - 2\nc: {d: '}', e: 5}\nf: !!opencv-matrix\n  rows: 4\n  data: [1,\n   2]\ng: "
      "1\n");
  const auto spelled = [&document](const std::string& path) {
    return std::string(document.source().text(at(document, path).span));
  };
  EXPECT_EQ(spelled("a"), "[1, [2, 3], \"]\"]");
  EXPECT_EQ(spelled("a/1"), "[2, 3]");
  EXPECT_EQ(spelled("b"), "- 1\n  - 2");
  EXPECT_EQ(spelled("c"), "{d: '}', e: 5}");
  EXPECT_TRUE(spelled("f").ends_with("rows: 4\n  data: [1,\n   2]")) << spelled("f");
  EXPECT_EQ(spelled("g"), "1");
  EXPECT_TRUE(at(document, "f").tag.ends_with("opencv-matrix")) << at(document, "f").tag;
  EXPECT_TRUE(at(document, "a").flow);
  EXPECT_FALSE(at(document, "b").flow);
}

TEST(TextYaml, QuotesAndMissingValues) {
  const Document document = document_of("a: \"x\\\"\\ty\"\nb: 'it''s'\nc:\nd: ''\ne: 1.0\n");
  EXPECT_EQ(at(document, "a").value, "x\"\ty");
  EXPECT_TRUE(at(document, "a").quoted);
  EXPECT_EQ(at(document, "b").value, "it's");
  EXPECT_EQ(document.source().text(at(document, "b").span), "'it''s'");
  EXPECT_EQ(at(document, "c").kind, text::NodeKind::kNull);
  EXPECT_EQ(document.source().position(at(document, "c").span.offset).line, 3);
  EXPECT_TRUE(at(document, "d").is_scalar());
  EXPECT_FALSE(at(document, "e").quoted);
}

TEST(TextYaml, TheFirstLineDecidesTheSyntax) {
  EXPECT_EQ(document_of("%YAML:1.0\na: 1\n").syntax(), text::Syntax::kOpenCvYaml);
  EXPECT_EQ(document_of("%YAML:1.0\n---\na: 1\n").syntax(), text::Syntax::kOpenCvYaml);
  EXPECT_EQ(document_of("%YAML 1.2\n---\na: 1\n").syntax(), text::Syntax::kYaml);
  EXPECT_EQ(document_of("a: 1\n").syntax(), text::Syntax::kYaml);
}

// FORMATS.md 0: every ORB-SLAM2 example has "Viewer.PointSize:2".
TEST(TextYaml, OpenCvKeysNeedNoBlank) {
  const std::string bytes =
      "%YAML:1.0\nViewer.PointSize:2\nCamera.fx:517.3 # x:y\nsub:\n   deep:7\n   'quo:ted': 1\nurl: \"http://a:80\"\n# "
      "c:d\nlist: [ 1, \"a:1\",\n"
      "  2 ]\n- x\n";
  const std::string good = bytes.substr(0, bytes.find("- x"));
  expect_spans(good);
  const Document document = document_of(good);
  EXPECT_EQ(at(document, "Viewer.PointSize").value, "2");
  EXPECT_EQ(at(document, "Camera.fx").value, "517.3");
  EXPECT_EQ(document.source().position(at(document, "Camera.fx").span.offset).column, 11);
  EXPECT_EQ(at(document, "sub/deep").value, "7");
  EXPECT_EQ(at(document, "sub/quo:ted").value, "1");
  EXPECT_EQ(at(document, "url").value, "http://a:80");
  EXPECT_EQ(at(document, "list/1").value, "a:1");
  EXPECT_EQ(document.bytes(), good);
}

TEST(TextYaml, ThePrePassTouchesBlockKeysOnly) {
  // {line, the same after the pre-pass}
  const std::pair<std::string, std::string> kLines[] = {
      {"key:1\n", "key: 1\n"},
      {"  a.b-c_9:x\n", "  a.b-c_9: x\n"},
      {"key: 1\n", "key: 1\n"},
      {"key:\n", "key:\n"},
      {"key:\r\n", "key:\r\n"},
      {"key:\t1\n", "key:\t1\n"},
      {"key:1", "key: 1"},
      {"key:", "key:"},
      {"- key:1\n", "- key: 1\n"},
      {"# key:1\n", "# key:1\n"},
      {"a: b:c\n", "a: b:c\n"},
      {"\"a:b\": 1\n", "\"a:b\": 1\n"},
      {"a: [x:1,\nkey:2\n]\nb:3\n", "a: [x:1,\nkey:2\n]\nb: 3\n"},
      {"a: {x:1,\nkey:2}\nb:3\n", "a: {x:1,\nkey:2}\nb: 3\n"},
      {"a: \"[\"\nb:3\n", "a: \"[\"\nb: 3\n"},
      {"a: 1 # [ {\nb:3\n", "a: 1 # [ {\nb: 3\n"},
      {"%YAML:1.0\n", "%YAML:1.0\n"},
  };
  for (const auto& [before, after] : kLines) {
    const text::SpacedText spaced = text::space_after_keys(before);
    EXPECT_EQ(spaced.text, after);
    for (std::size_t i = 0; i < spaced.text.size(); ++i) {
      const bool inserted = std::ranges::find(spaced.insertions, i) != spaced.insertions.end();
      if (!inserted) {
        EXPECT_EQ(before[spaced.original_offset(i)], spaced.text[i]) << before << " at " << i;
      }
    }
  }
}

// PyYAML and yaml-cpp refuse the tight colon (FORMATS.md 0), and so must the plain reader: it would be a key of that name.
TEST(TextYaml, PlainYamlKeysNeedTheirBlank) {
  EXPECT_EQ(parse("a: 1\nb:2\nc: 3\n").codes(), "blank-missing");
  EXPECT_EQ(parse("a: 1\nb:2\n").codes(), "blank-missing") << "on the last line, too";
  EXPECT_EQ(parse("cam0:\n  a: 1\n  rostopic:/cam0\n").codes(), "blank-missing");
}

// What the file's end cuts off is not complete; PyYAML refuses each of these ("while scanning a quoted scalar", "did not find
// expected").
TEST(TextYaml, WhatTheEndOfTheFileCutsOffIsRefused) {
  for (const char* bytes : {"a: \"b\n", "a: 'b", "a: \"b", "a: [1, 2", "a: {b: 1", "a: [\"x\", 'y"}) {
    const Parsed parsed = parse(bytes);
    EXPECT_FALSE(parsed.document) << bytes;
  }
}

struct Refused {
  const char* what;
  std::string bytes;
  const char* place_and_code;
  Message facts;
};

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

TEST(TextYaml, RefusalsNameTheDefectAndItsPlace) {
  const std::string kTwoMebibytes(2u * 1024u * 1024u, '#');
  const Refused kRefused[] = {
      {"empty", "", "- empty-file", {Code::kFileEmpty}},
      {"blank lines", " \r\n\t\n", "- empty-file", {Code::kFileEmpty}},
      {"only a BOM", "\xEF\xBB\xBF", "- empty-file", {Code::kFileEmpty}},
      {"zero byte", std::string("a: 1\nb: \0 2\n", 12), "2:4 binary-file", {Code::kFileBinary}},
      {"UTF-16, its mark first",
       std::string("\xFF\xFE"
                   "a\0:\0\n\0",
                   8),
       "- utf-16",
       {Code::kFileUtf16}},
      {"UTF-16 without a mark", std::string("\0a\0:\0\n", 6), "- utf-16", {Code::kFileUtf16}},
      {"CR alone", "a: 1\rb: 2\r", "1:5 cr-line-ends", {Code::kFileCrOnly}},
      {"too large", kTwoMebibytes + "\n", "- too-large", {Code::kFileTooLarge, {2}}},
      {"anchor", "%YAML:1.0\nb: &x 2\nc: 3\n", "2:4 yaml-anchor", {Code::kYamlAnchor}},
      {"anchor on a map", "%YAML:1.0\na: &x\n  b: 1\n", "2:4 yaml-anchor", {Code::kYamlAnchor}},
      {"alias of what is open", "a: &x\n  b: *x\n", "2:6 yaml-alias", {Code::kYamlAlias}},
      {"alias of nothing", "a: *x\n", "1:4 yaml-alias", {Code::kYamlAlias}},
      {"alias as a key", "a: &x b\n*x : 1\n", "2:1 yaml-alias", {Code::kYamlAlias}},
      {"merge of a number", "a:\n  <<: 1\n", "2:3 yaml-alias", {Code::kYamlMergeKey}},
      {"alias", "%YAML:1.0\na: 1\nb:  *x\n", "3:5 yaml-alias", {Code::kYamlAlias}},
      {"documents", "a: 1\n---\nb: 2\n", "3:1 yaml-documents", {Code::kYamlDocuments}},
      {"depth 65", "a: " + repeated("[", 64) + repeated("]", 64) + "\n", "1:67 too-deep", {Code::kTooDeep, {64}}},
      {"conflict", "a: 1\n<<<<<<< HEAD\nb: 2\n=======\nb: 3\n>>>>>>> x\n", "2:1 merge-conflict", {Code::kMergeConflict}},
      {"TAB", "a:\n\tb: 1\n", "2:1 yaml-tab", {Code::kYamlTab}},
      {"TAB behind blanks", "a:\n  b: 1\n  \tc: 2\n", "3:3 yaml-tab", {Code::kYamlTab}},
  };
  for (const Refused& row : kRefused) {
    const Parsed parsed = parse(row.bytes);
    EXPECT_FALSE(parsed.document) << row.what;
    ASSERT_EQ(parsed.diagnostics.entries().size(), 1U) << row.what;
    const Diagnostic& said = parsed.diagnostics.entries().front();
    EXPECT_EQ(said.severity, Severity::kError) << row.what;
    EXPECT_EQ(said.facts, row.facts) << row.what << ": " << parsed.rendered().substr(0, 300);
    EXPECT_EQ(place_and_code(row.bytes, "file.yaml"), row.place_and_code) << row.what;
  }
}

TEST(TextYaml, LimitsAreWhereTheySay) {
  EXPECT_TRUE(parse("a: " + repeated("[", 63) + repeated("]", 63) + "\n").document);
  const std::string most = "a: 1\n#" + std::string(2u * 1024u * 1024u - 6, 'x');
  ASSERT_EQ(most.size(), 2u * 1024u * 1024u);
  EXPECT_TRUE(parse(most).document);
  EXPECT_FALSE(parse(most + "x").document);
  // Other documents without content are harmless: "---" at the start, "..." at the end.
  EXPECT_TRUE(parse("---\na: 1\n...\n").document);
  EXPECT_TRUE(parse("a: 1\n---\n").document);
}

// A parser must not recurse: yaml-cpp's own guard or ours has to stop it, in time.
TEST(TextYaml, HostileNestingIsRefused) {
  for (const char* part : {"[", "{", "- ", "a: {", "? ", "[\"a\", "}) {
    const Parsed parsed = parse("%YAML:1.0\na: " + repeated(part, 100'000));
    EXPECT_FALSE(parsed.document) << part;
    EXPECT_FALSE(parsed.codes().empty()) << part;
  }
}

TEST(TextYaml, SyntaxErrorsHaveALine) {
  const Parsed parsed = parse("a: 1\nb: [1, 2\nc: 3\n");
  EXPECT_FALSE(parsed.document);
  EXPECT_EQ(parsed.codes(), "yaml-syntax");
  const SourceRange& where = parsed.diagnostics.entries().at(0).where;
  EXPECT_EQ(where.file, "file.yaml");
  EXPECT_GT(parsed.source.position(where.offset).line, 1);
}

TEST(TextYaml, ConflictMarkersInsideTextAreText) { EXPECT_TRUE(parse("# see <<<<<<< HEAD\na: \"<<<<<<< \"\n").document); }

// As a full disk leaves it: not the blank of a key is missing, but the rest.
TEST(TextYaml, AFileThatEndsEarlyIsToldSo) {
  const auto code = [](const std::string& bytes) {
    const Parsed parsed = parse(bytes, "a.yaml");
    return parsed.diagnostics.entries().empty() ? Code::kNone : parsed.diagnostics.entries().front().facts.code;
  };
  for (const char* bytes :
       {"a: 1\nintrin", "a:\n  b: [1, 2", "a:\n  b: [1, 2,\n", "a: {b: 1", "a: 1\nb: \"rad", "a: 1\nb: [0.1, -",
        "%YAML:1.0\nViewer.PointSize:2\nCame", "%YAML:1.0\nm: !!opencv-matrix\n   data: [ 1., 0.,"})
    EXPECT_EQ(code(bytes), Code::kYamlEndsEarly) << bytes;
  for (const char* bytes : {"a: 1\nintrin\n", "a: [1, 2\nb: 3\n", "a: \"x\nb: 1\n"})
    EXPECT_NE(code(bytes), Code::kYamlEndsEarly) << bytes;
  EXPECT_EQ(code("a: 1\nb:2"), Code::kYamlBlankMissing);
}

}  // namespace
}  // namespace fca::test
