// SPDX-License-Identifier: BSD-3-Clause
// FORMATS.md section 0: the same bytes mean different things to PyYAML and to cv::FileStorage. Where the
// readers can be asked (the consumers' PyYAML, OpenCV itself) they are, too.
#include "formats/test_files.h"
#include "pyyaml.h"

#include <fca/formats/text/dialect.h>

#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

namespace fca::text {
namespace {

struct Row {
  const char* spelling;
  ScalarType pyyaml;
  ScalarType opencv;
  bool opencv_opens = true;  ///< false: cv::FileStorage stops at it
};

constexpr ScalarType kText = ScalarType::kText;
constexpr ScalarType kInteger = ScalarType::kInteger;
constexpr ScalarType kReal = ScalarType::kReal;

// PyYAML's resolver: a sign wants a digit after it (-.5 is a string), an exponent a point in front and a sign after.
constexpr Row kRows[] = {
    {"1.5", kReal, kReal},
    {"-1.5", kReal, kReal},
    {"+1.5", kReal, kReal},
    {"1.", kReal, kReal},
    {".5", kReal, kReal},
    {"0.0", kReal, kReal},
    {"1e-5", kText, kReal},
    {"1.0e5", kText, kReal},
    {"1.0e-05", kReal, kReal},
    {"1.0e+05", kReal, kReal},
    {"1.5E+3", kReal, kReal},
    {"1.e5", kText, kReal},
    {"1E5", kText, kInteger, false},
    {"20", kInteger, kInteger},
    {"-3", kInteger, kInteger},
    {"+3", kInteger, kInteger},
    {"017", kInteger, kInteger},
    {"0", kInteger, kInteger},
    {"4000000000", kInteger, kInteger},
    {".nan", kReal, kReal},
    {".NaN", kReal, kReal},
    {".Nan", kText, kReal},
    {".inf", kReal, kReal},
    {".Inf", kReal, kReal},
    {"-.inf", kReal, kReal},
    {"nan", kText, kText},
    {"inf", kText, kText},
    {"PinHole", kText, kText},
    {"1,5", kText, kInteger, false},
    {"\"1.5\"", kText, kText},
    {"'20'", kText, kText},
    {"-.5", kText, kReal},
    {"+.5", kText, kReal},
    {"-.5e-3", kText, kReal},
    {"_1.5", kText, kText},
    {"a1", kText, kText},
    {"-x", kText, kText},
};

const Node& value_in(const Document& document) { return document.root().entries.front().value; }

TEST(Dialect, TypesOfTheTable) {
  for (const Row& row : kRows) {
    const Document document = test::document_of(std::string("a: ") + row.spelling + "\n");
    EXPECT_EQ(scalar_type(value_in(document), Dialect::kPyYaml), row.pyyaml) << row.spelling;
    EXPECT_EQ(scalar_type(value_in(document), Dialect::kOpenCv), row.opencv) << row.spelling;
  }
}

TEST(Dialect, PyYamlAgrees) {
  using consumers::pyyaml::Kind;
  for (const Row& row : kRows) {
    if (row.spelling[0] == '"' || row.spelling[0] == '\'') continue;
    const Kind kind = consumers::pyyaml::resolve_plain_scalar(row.spelling).kind;
    const ScalarType type = kind == Kind::kFloat ? kReal : kind == Kind::kInt ? kInteger : kText;
    EXPECT_EQ(row.pyyaml, type) << row.spelling;
  }
}

TEST(Dialect, OpenCvAgrees) {
  for (const Row& row : kRows) {
    const std::string yaml = std::string("%YAML:1.0\na: ") + row.spelling + "\n";
    try {
      const cv::FileStorage storage(yaml, cv::FileStorage::READ | cv::FileStorage::MEMORY);
      const cv::FileNode node = storage["a"];
      const ScalarType type = node.isReal() ? kReal : node.isInt() ? kInteger : kText;
      EXPECT_TRUE(row.opencv_opens) << row.spelling;
      EXPECT_EQ(row.opencv, type) << row.spelling;
    } catch (const cv::Exception&) {
      EXPECT_FALSE(row.opencv_opens) << row.spelling;
    }
  }
}

TEST(Dialect, OfDuplicateKeysPyYamlTakesTheLastAndOpenCvTheFirst) {
  const Document document = test::document_of("a: 1\nb: 2\na: 3\n");
  EXPECT_EQ(find(document.root(), "a", Dialect::kPyYaml)->value, "3");
  EXPECT_EQ(find(document.root(), "a", Dialect::kOpenCv)->value, "1");
  EXPECT_EQ(find_entry(document.root(), "a", Dialect::kPyYaml), &document.root().entries[2]);
  EXPECT_EQ(find_entry(document.root(), "a", Dialect::kOpenCv), &document.root().entries[0]);
}

TEST(Dialect, WhatIsNotThereIsNull) {
  const Document document = test::document_of("a: [1]\n'b': 2\n");
  EXPECT_EQ(find(document.root(), "c", Dialect::kPyYaml), nullptr);
  EXPECT_EQ(find(document.root(), "c", Dialect::kOpenCv), nullptr);
  EXPECT_EQ(find(document.root(), "A", Dialect::kOpenCv), nullptr);
  EXPECT_EQ(find(test::at(document, "a"), "a", Dialect::kOpenCv), nullptr);
  EXPECT_NE(find(document.root(), "b", Dialect::kPyYaml), nullptr);
}

TEST(Dialect, OnlyScalarsHaveAType) {
  const Document document = test::document_of("a: [1]\nb:\n");
  EXPECT_EQ(scalar_type(test::at(document, "a"), Dialect::kOpenCv), kText);
  EXPECT_EQ(scalar_type(test::at(document, "b"), Dialect::kPyYaml), kText);
}

}  // namespace
}  // namespace fca::text
