// SPDX-License-Identifier: BSD-3-Clause
// The tree of cv::FileStorage's XML, and what is said about a file that is none.
#include "formats/text_checks.h"

#include <fca/code.h>
#include <fca/formats/text/dialect.h>

#include <opencv2/core/persistence.hpp>

namespace fca::test {
namespace {

using text::Document;
using text::NodeKind;
using text::Syntax;

constexpr const char* kSample = R"(<?xml version="1.0"?>
<!-- made by hand -->
<opencv_storage>
<calibration_time>"Thu &lt;1&gt; &amp; &quot;2&quot;"</calibration_time>
<image_width>640</image_width>
<camera_matrix type_id="opencv-matrix">
  <rows>2</rows>
  <cols>2</cols>
  <dt>d</dt>
  <data>
    5.5e+02 0. <!-- skew -->
    -1.25 1.</data></camera_matrix>
<size>
  3008 2000</size>
<rows_of><_>1 2</_><_>
  3 4</_></rows_of>
<words>cam/0.png "two words" .5</words>
<one><_>7</_></one>
<empty></empty><void/>
<nested a='>' ><x>1</x>
  <y><z>2</z></y></nested >
</opencv_storage>
)";

Document xml_of(const std::string& bytes) {
  Parsed parsed = parse(bytes, "file.xml");
  EXPECT_TRUE(parsed.document) << parsed.rendered();
  if (!parsed.document) return {};
  EXPECT_EQ(parsed.document->syntax(), Syntax::kXml);
  return *std::move(parsed.document);
}

std::string storage(const std::string& inner) {
  return "<?xml version=\"1.0\"?>\n<opencv_storage>\n" + inner + "\n</opencv_storage>\n";
}

TEST(TextXml, TheTree) {
  const Document document = xml_of(kSample);
  const auto spelled = [&document](const std::string& path) {
    return std::string(document.source().text(at(document, path).span));
  };
  EXPECT_TRUE(document.root().is_mapping());
  EXPECT_FALSE(document.root().flow);
  EXPECT_EQ(document.root().entries.size(), 10U);
  EXPECT_EQ(at(document, "calibration_time").value, "Thu <1> & \"2\"");
  EXPECT_TRUE(at(document, "calibration_time").quoted);
  EXPECT_EQ(spelled("calibration_time"), "\"Thu &lt;1&gt; &amp; &quot;2&quot;\"");
  EXPECT_EQ(at(document, "image_width").value, "640");
  EXPECT_EQ(at(document, "camera_matrix").tag, "tag:yaml.org,2002:opencv-matrix");
  EXPECT_EQ(at(document, "camera_matrix").tag, at(document_of("%YAML:1.0\na: !!opencv-matrix\n   rows: 1\n"), "a").tag);
  EXPECT_EQ(at(document, "camera_matrix/data").items.size(), 4U) << "a comment between numbers";
  EXPECT_EQ(spelled("camera_matrix/data/2"), "-1.25");
  EXPECT_EQ(document.source().position(at(document, "camera_matrix/data/2").span.offset).line, 12);
  EXPECT_EQ(document.source().position(at(document, "camera_matrix/data/2").span.offset).column, 5);
  EXPECT_EQ(spelled("size"), "3008 2000");
  EXPECT_EQ(at(document, "rows_of").items.size(), 2U);
  EXPECT_EQ(spelled("rows_of"), "<_>1 2</_><_>\n  3 4</_>");
  EXPECT_EQ(spelled("rows_of/1/0"), "3");
  EXPECT_EQ(at(document, "words").items.size(), 3U);
  EXPECT_EQ(at(document, "words/0").value, "cam/0.png");
  EXPECT_EQ(spelled("words/1"), "\"two words\"");
  EXPECT_TRUE(at(document, "one").is_sequence());
  EXPECT_EQ(at(document, "one/0").value, "7");
  EXPECT_EQ(at(document, "empty").kind, NodeKind::kNull);
  EXPECT_EQ(at(document, "void").kind, NodeKind::kNull);
  EXPECT_EQ(spelled("nested"), "<x>1</x>\n  <y><z>2</z></y>");
  EXPECT_EQ(at(document, "nested/y/z").value, "2");
  EXPECT_EQ(document.source().text(document.extent(entry_at(document.root(), "void"))), "<void/>");
  EXPECT_TRUE(document.source().text(document.extent(entry_at(document.root(), "nested"))).ends_with("</nested >"));
  EXPECT_EQ(document.bytes(), kSample);
  EXPECT_EQ(expect_scalar_spans(document), 17 + 21);
  expect_nested_spans(document.root(), document.bytes().size());
}

TEST(TextXml, BomCrlfUtf8AndNoDeclaration) {
  std::string crlf = kSample;
  for (std::size_t at = 0; (at = crlf.find('\n', at)) != std::string::npos; at += 2) crlf.replace(at, 1, "\r\n");
  for (const std::string& bytes :
       {crlf, "\xEF\xBB\xBF" + crlf, std::string("<opencv_storage><a>1 2</a></opencv_storage>"),
        storage("<t>\"\xE5\xB9\xB4 \xC3\xA4\"</t><!-- \xE5\xB9\xB4 --><a>1.5</a>"), storage("<t>\"M\xFCnchen\"</t><a>1.5</a>"),
        storage("<t>\"a\r\nb\"</t><a>1.5\r2.5\n\r3.5</a>")}) {
    const Document document = xml_of(bytes);
    EXPECT_EQ(document.bytes(), bytes);
    if (bytes.find("\"a\r\nb\"") == std::string::npos) {
      EXPECT_GE(expect_scalar_spans(document), 3);
    }
  }
  EXPECT_EQ(at(xml_of(storage("<t>\"a\r\nb\"</t>")), "t").value, "a\nb");
  EXPECT_EQ(at(xml_of(storage("<t>\"&#65;&#x42;&#228;&#x20AC;\"</t>")), "t").value, "AB\xC3\xA4\xE2\x82\xAC");
}

TEST(TextXml, DuplicateElementsAreKeptAndTheFirstCounts) {
  const Document document = xml_of(storage("<a>1</a><b>2</b><a>3</a>"));
  ASSERT_EQ(document.root().entries.size(), 3U);
  EXPECT_EQ(text::find(document.root(), "a", text::Dialect::kOpenCv)->value, "1");
  const cv::FileStorage theirs(document.bytes(), cv::FileStorage::READ | cv::FileStorage::MEMORY);
  EXPECT_EQ(static_cast<int>(theirs["a"]), 1);
}

TEST(TextXml, WhatIsWrongAndWhere) {
  struct Row {
    std::string bytes;
    const char* place_and_code;
    Message facts;
  };
  const Row kRows[] = {
      {"<opencv_storage>\n<a>1</b>\n</opencv_storage>\n", "2:5 xml-syntax", {Code::kXmlClosesAnother, {"b", "a", 2}}},
      {"<opencv_storage>\n  <a>1\n</opencv_storage>\n",
       "3:1 xml-syntax",
       {Code::kXmlClosesAnother, {"opencv_storage", "a", 2}}},
      {"<opencv_storage>\n<a>1</a>\n", "1:1 xml-syntax", {Code::kXmlElementOpen, {"opencv_storage"}}},
      {"<opencv_storage>\n <a>1", "2:2 xml-syntax", {Code::kXmlElementOpen, {"a"}}},
      {"<opencv_storage>\n <a>1</", "2:6 xml-syntax", {Code::kXmlTagOpen}},
      {"<opencv_storage>\n <a", "2:2 xml-syntax", {Code::kXmlTagOpen}},
      {"<opencv_storage>\n <!-- a", "2:2 xml-syntax", {Code::kXmlTagOpen}},
      {"<?xml version=\"1.0\"", "1:1 xml-syntax", {Code::kXmlTagOpen}},
      {"<?xml version=\"1.0\"?>\n", "1:22 xml-syntax", {Code::kXmlNoElement}},
      {"<opencv_storage/>\n<opencv_storage/>\n", "2:1 xml-syntax", {Code::kXmlSecondRoot}},
      {"<opencv_storage></opencv_storage>\n x\n", "2:2 xml-syntax", {Code::kXmlTextOutside}},
      {"</opencv_storage>\n", "1:1 xml-syntax", {Code::kXmlClosesNothing, {"opencv_storage"}}},
      {storage("<a>1</a></a>"), "3:9 xml-syntax", {Code::kXmlClosesAnother, {"a", "opencv_storage", 2}}},
      {"<!DOCTYPE a [<!ENTITY b \"c\">]>\n<opencv_storage/>\n", "1:1 xml-declaration", {Code::kXmlDeclaration}},
      {storage("<a><![CDATA[1]]></a>"), "3:4 xml-declaration", {Code::kXmlDeclaration}},
      {storage("<a>1</a><?b?>"), "3:9 xml-syntax", {Code::kXmlInstruction}},
      {storage("<a>\"b & c\"</a>"), "3:7 xml-syntax", {Code::kXmlUnknownEntity}},
      {storage("<a>\"&nbsp;\"</a>"), "3:5 xml-syntax", {Code::kXmlUnknownEntity}},
      {storage("<a>\"&#0;\"</a>"), "3:5 xml-syntax", {Code::kXmlUnknownEntity}},
      {storage("<a>\"b</a>"), "3:4 xml-syntax", {Code::kXmlQuoteOpen}},
      {storage("<a>b\"c</a>"), "3:5 xml-syntax", {Code::kXmlQuoteInWord}},
      {storage("<a>\"b\"c</a>"), "3:7 xml-syntax", {Code::kXmlBlankMissing}},
      {storage("<a>1 < 2</a>"), "3:6 xml-syntax", {Code::kXmlTagOpen}},
      {storage("<a b=c>1</a>"), "3:1 xml-syntax", {Code::kXmlAttribute}},
      {storage("<a>1 <b>2</b></a>"), "3:2 xml-mixed", {Code::kXmlMixed, {"a"}}},
      {"<lens><f>1</f></lens>", "1:2 xml-root", {Code::kXmlRoot, {"lens"}}},
      {"\xEF\xBB\xBF<lens><f>1</f></lens>", "1:2 xml-root", {Code::kXmlRoot, {"lens"}}},
      {"opencv_storage>\n<a>1</a>", "1:1 xml-syntax", {Code::kXmlTextOutside}},
  };
  for (const Row& row : kRows) {
    EXPECT_EQ(place_and_code(row.bytes, "a.xml"), row.place_and_code) << row.bytes;
    const Parsed parsed = parse(row.bytes, "a.xml");
    EXPECT_EQ(parsed.diagnostics.entries().at(0).facts, row.facts) << row.bytes << "\n" << parsed.rendered();
  }
}

TEST(TextXml, NestingHasALimit) {
  const auto nested = [](std::size_t depth) {
    std::string bytes = "<opencv_storage>";
    for (std::size_t i = 1; i < depth; ++i) bytes += "<_>";
    bytes += "1";
    for (std::size_t i = 1; i < depth; ++i) bytes += "</_>";
    return bytes + "</opencv_storage>";
  };
  EXPECT_TRUE(parse(nested(text::kMaxDepth), "a.xml").document);
  EXPECT_EQ(place_and_code(nested(text::kMaxDepth + 1), "a.xml"), "1:206 too-deep");
  EXPECT_EQ(parse(nested(200'000), "a.xml").codes(), "too-deep");
}

TEST(TextXml, TruncationsAreHarmless) { expect_truncations_are_harmless(kSample, "a.xml"); }

// Never a wrong span: whatever a change turns the file into, the bytes at a scalar are its value, or the file is refused.
TEST(TextXml, ChangedBytesAreHarmless) {
  std::mt19937 random(11);
  const std::string kOdd = "<>/&;\"'!-?=# \n\r\t\x80_a1.";
  int read = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string bytes = kSample;
    for (int k = 0; k < 2; ++k) bytes[random() % bytes.size()] = kOdd[random() % kOdd.size()];
    const Parsed parsed = parse(bytes, "a.xml");
    EXPECT_EQ(parsed.codes().find("xml-place"), std::string::npos) << bytes;
    if (!parsed.document) continue;
    ++read;
    expect_nested_spans(parsed.document->root(), bytes.size());
    if (bytes.find('\r') == std::string::npos) expect_scalar_spans(*parsed.document);
  }
  EXPECT_GT(read, 200);
}

TEST(TextXml, EditsStayInTheirPlace) {
  for (unsigned seed = 0; seed < 50; ++seed) expect_edits_stay_in_their_place(xml_of(kSample), seed);
}

}  // namespace
}  // namespace fca::test
