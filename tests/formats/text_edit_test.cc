// SPDX-License-Identifier: BSD-3-Clause
// Edits in JSON, XML and words: entries removed and added, fields taken from one value to another.
#include "fields.h"
#include "formats/text_checks.h"

#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

namespace fca::test {
namespace {

using fields::Field;
using text::Dialect;
using text::Document;
using text::Syntax;

constexpr const char* kJson = "{\n    \"a\": 1,\n    \"b\": [1, 2],\n    \"c\": {\"x\": 1, \"y\": 2, \"z\": 3}\n}\n";
constexpr const char* kXml =
    "<?xml version=\"1.0\"?>\n<opencv_storage>\n<a>1</a> <!-- one -->\n<b>\n  1 2</b>\n<!-- c -->\n<c><x>1</x><y>2</y>\n  "
    "<z>3</z></c>\n</opencv_storage>\n";

std::string crlf(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
  return text;
}

/// `bytes` without these keys of the mapping at `path` ("" for the root).
std::string without(const std::string& bytes, const std::string& path, const std::vector<std::string>& keys) {
  Document document = document_of(bytes);
  const text::Node& mapping = path.empty() ? document.root() : at(document, path);
  for (const std::string& key : keys) document.remove_entry(mapping, entry_at(mapping, key));
  return document.bytes();
}

std::string with(const std::string& bytes, const std::string& path, const std::string& key, const std::string& lines) {
  Document document = document_of(bytes);
  const text::Node& mapping = path.empty() ? document.root() : at(document, path);
  document.insert_after(mapping, entry_at(mapping, key), lines);
  return document.bytes();
}

std::string keys_of(const std::string& bytes, const std::string& path) {
  const Document document = document_of(bytes);
  std::string keys;
  for (const text::Entry& entry : (path.empty() ? document.root() : at(document, path)).entries) keys += entry.key.value;
  return keys;
}

TEST(TextEdit, JsonEntriesGoWithTheirComma) {
  EXPECT_EQ(without(kJson, "", {"a"}), with_replaced(kJson, "\"a\": 1,\n    ", ""));
  EXPECT_EQ(without(kJson, "", {"b"}), with_replaced(kJson, ",\n    \"b\": [1, 2]", ""));
  EXPECT_EQ(without(kJson, "c", {"z"}), with_replaced(kJson, ", \"z\": 3", ""));
  EXPECT_EQ(without(crlf(kJson), "", {"b"}), with_replaced(crlf(kJson), ",\r\n    \"b\": [1, 2]", ""));
}

// Whatever goes, in whatever order: what is left is JSON of the keys that stay.
TEST(TextEdit, AnySubsetOfJsonEntriesMayGo) {
  for (const char* path : {"", "c"}) {
    const std::string all = keys_of(kJson, path);
    for (unsigned mask = 0; mask < 8; ++mask) {
      std::vector<std::string> keys;
      std::string rest;
      for (std::size_t i = 0; i < 3; ++i) {
        if ((mask >> i & 1U) != 0)
          keys.emplace_back(1, all[i]);
        else
          rest += all[i];
      }
      EXPECT_EQ(keys_of(without(kJson, path, keys), path), rest);
      std::ranges::reverse(keys);
      EXPECT_EQ(keys_of(without(kJson, path, keys), path), rest);
    }
  }
}

TEST(TextEdit, JsonEntriesComeAsTheirNeighboursStand) {
  EXPECT_EQ(with(kJson, "", "a", "\"n\": {\n    \"m\": 2\n}"),
            with_replaced(kJson, "\"a\": 1", "\"a\": 1,\n    \"n\": {\n        \"m\": 2\n    }"));
  EXPECT_EQ(with(kJson, "", "c", "\"n\": 2"), with_replaced(kJson, "3}", "3},\n    \"n\": 2"));
  EXPECT_EQ(with(kJson, "c", "x", "\"n\": 2"), with_replaced(kJson, "\"x\": 1", "\"x\": 1, \"n\": 2"));
  EXPECT_EQ(with(crlf(kJson), "", "a", "\"n\": 2"), with_replaced(crlf(kJson), "\"a\": 1", "\"a\": 1,\r\n    \"n\": 2"));
  EXPECT_EQ(with("{\n\t\"a\": 1\n}\n", "", "a", "\"n\": [\n    2]"), "{\n\t\"a\": 1,\n\t\"n\": [\n\t    2]\n}\n");
}

TEST(TextEdit, XmlElementsGoWithTheirLines) {
  EXPECT_EQ(without(kXml, "", {"a"}), with_replaced(kXml, "<a>1</a> <!-- one -->\n", ""));
  EXPECT_EQ(without(kXml, "", {"b"}), with_replaced(kXml, "<b>\n  1 2</b>\n", ""));
  EXPECT_EQ(without(kXml, "c", {"y"}), with_replaced(kXml, "<y>2</y>", ""));
  EXPECT_EQ(without(kXml, "c", {"z"}), with_replaced(kXml, "\n  <z>3</z>", ""));
  EXPECT_EQ(without(crlf(kXml), "c", {"z"}), with_replaced(crlf(kXml), "\r\n  <z>3</z>", ""));
  EXPECT_EQ(without(crlf(kXml), "", {"a"}), with_replaced(crlf(kXml), "<a>1</a> <!-- one -->\r\n", ""));
}

TEST(TextEdit, XmlElementsComeAsTheirNeighboursStand) {
  EXPECT_EQ(with(kXml, "", "a", "<n>\n  2</n>"), with_replaced(kXml, "one -->\n", "one -->\n<n>\n  2</n>\n"));
  EXPECT_EQ(with(kXml, "c", "x", "<n>2</n>"), with_replaced(kXml, "<x>1</x>", "<x>1</x><n>2</n>"));
  EXPECT_EQ(with(kXml, "c", "z", "<n>\n  2</n>"), with_replaced(kXml, "<z>3</z>", "<z>3</z>\n  <n>\n    2</n>"));
  EXPECT_EQ(with(crlf(kXml), "", "b", "<n>2</n>"), with_replaced(crlf(kXml), "1 2</b>\r\n", "1 2</b>\r\n<n>2</n>\r\n"));
}

const std::vector<double> kNumbers = {1.5, -2.0, 2e-5, 4.0};

std::vector<Field> sample_fields() {
  Transform T;
  T(0, 3) = 0.125;
  return {fields::real("fx", 350.25),
          fields::integer("width", 640),
          fields::quoted("name", "a<b>&\"c' \xC3\xA4"),
          fields::scalar("model", "pinhole"),
          fields::list("D", kNumbers),
          fields::list("one", std::vector{7.5}),
          fields::rows("T", T),
          fields::matrix("K", kNumbers, 2, "d")};
}

std::string fresh(Syntax syntax, std::span<const Field> all) {
  std::string bytes = syntax == Syntax::kJson ? "{\n" : "<?xml version=\"1.0\"?>\n<opencv_storage>\n";
  for (const Field& field : all) {
    bytes += fields::spell(field, syntax == Syntax::kJson ? 4 : 0, syntax);
    bytes += syntax == Syntax::kJson && &field != &all.back() ? ",\n" : "\n";
  }
  return bytes + (syntax == Syntax::kJson ? "}\n" : "</opencv_storage>\n");
}

/// Our reader and cv::FileStorage find in `bytes` what sample_fields() says.
void expect_sample(const std::string& bytes) {
  SCOPED_TRACE(bytes);
  const Document document = document_of(bytes);
  Diagnostics diagnostics;
  fields::Reader reader(document, Dialect::kOpenCv, diagnostics);
  const text::Node& root = document.root();
  const auto node = [&](const char* key) -> const text::Node& {
    static const text::Node kMissing;
    const text::Node* found = reader.require(root, key, "file");
    return found == nullptr ? kMissing : *found;
  };
  EXPECT_EQ(reader.real(node("fx"), "fx"), 350.25);
  EXPECT_EQ(reader.integer(node("width"), "width"), 640);
  EXPECT_EQ(reader.string(node("name"), "name"), "a<b>&\"c' \xC3\xA4");
  EXPECT_EQ(reader.string(node("model"), "model"), "pinhole");
  EXPECT_EQ(reader.reals(node("D"), 4, "D"), kNumbers);
  EXPECT_EQ(reader.reals(node("one"), 1, "one"), std::vector{7.5});
  const std::optional<Transform> T = reader.transform(node("T"), "T");
  ASSERT_TRUE(T);
  EXPECT_EQ((*T)(0, 3), 0.125);
  const auto K = reader.opencv_matrix(node("K"), "K");
  ASSERT_TRUE(K);
  EXPECT_EQ(K->rows, 2);
  EXPECT_EQ(K->values, kNumbers);
  EXPECT_TRUE(node("K").tag.ends_with("opencv-matrix"));
  EXPECT_TRUE(diagnostics.entries().empty());

  const cv::FileStorage storage(bytes, cv::FileStorage::READ | cv::FileStorage::MEMORY);
  EXPECT_TRUE(storage["fx"].isReal());
  EXPECT_EQ(static_cast<double>(storage["fx"]), 350.25);
  EXPECT_TRUE(storage["width"].isInt());
  EXPECT_EQ(static_cast<std::string>(storage["name"]), "a<b>&\"c' \xC3\xA4");
  EXPECT_EQ(static_cast<std::string>(storage["model"]), "pinhole");
  EXPECT_EQ(static_cast<double>(storage["D"][2]), 2e-5);
  EXPECT_EQ(storage["one"].size(), 1U);
  EXPECT_EQ(static_cast<double>(storage["T"][0][3]), 0.125);
  const cv::Mat matrix = storage["K"].mat();
  ASSERT_EQ(matrix.size(), cv::Size(2, 2));
  EXPECT_EQ(matrix.at<double>(1, 0), 2e-5);
}

TEST(TextEdit, FreshFieldsAreReadByUsAndByOpenCv) {
  expect_sample(fresh(Syntax::kJson, sample_fields()));
  expect_sample(fresh(Syntax::kXml, sample_fields()));
  EXPECT_EQ(fields::spell(fields::matrix("K", kNumbers, 2, "f"), 2, Syntax::kXml),
            "  <K type_id=\"opencv-matrix\">\n    <rows>2</rows>\n    <cols>2</cols>\n    <dt>f</dt>\n    <data>\n      1.5 "
            "-2.0\n      2.0e-05 4.0</data>\n  </K>");
}

// Nothing to say, nothing touched; something to say, and that is what is read.
TEST(TextEdit, FieldsTakeAFileFromOneSayingToAnother) {
  Transform T;
  const std::vector<Field> other = {fields::real("fx", 1.0),
                                    fields::integer("width", 2),
                                    fields::quoted("name", "x"),
                                    fields::scalar("model", "omni"),
                                    fields::list("D", std::vector{1.0, 2.0, 3.0, 4.0}),
                                    fields::list("one", std::vector{1.0, 2.0}),
                                    fields::rows("T", T),
                                    fields::matrix("K", std::vector{1.0, 2.0, 3.0}, 3, "f")};
  for (const Syntax syntax : {Syntax::kJson, Syntax::kXml}) {
    for (const bool carriage_returns : {false, true}) {
      const std::string sample = fresh(syntax, sample_fields());
      const std::string bytes = carriage_returns ? crlf(sample) : sample;
      Document same = document_of(bytes);
      fields::apply(same, same.root(), Dialect::kOpenCv, {}, sample_fields());
      EXPECT_FALSE(same.edited()) << same.bytes();

      const std::string changed = carriage_returns ? crlf(fresh(syntax, other)) : fresh(syntax, other);
      Document document = document_of(changed);
      fields::apply(document, document.root(), Dialect::kOpenCv, other, sample_fields());
      expect_sample(document.bytes());
      EXPECT_EQ(std::ranges::count(document.bytes(), '\r') > 0, carriage_returns);
      const std::string edited = document.bytes();
      EXPECT_EQ(std::ranges::count(edited, '\r'), carriage_returns ? std::ranges::count(edited, '\n') : 0);

      // Fields that vanish and come back, next to one that is nobody's and one that stays.
      const std::string odd = syntax == Syntax::kJson ? "{\n    \"odd\": 1, \"gone\": [3, 4]\n}\n"
                                                      : "<?xml version=\"1.0\"?>\n<opencv_storage>\n<odd>1</odd><gone>3 "
                                                        "4</gone>\n</opencv_storage>\n";
      Document grown = document_of(carriage_returns ? crlf(odd) : odd);
      const std::vector<Field> gone = {fields::list("gone", std::vector{3.0, 4.0})};
      fields::apply(grown, grown.root(), Dialect::kOpenCv, gone, sample_fields());
      expect_sample(grown.bytes());
      EXPECT_EQ(keys_of(grown.bytes(), "").find("gone"), std::string::npos);
      EXPECT_EQ(at(document_of(grown.bytes()), "odd").value, "1");
    }
  }
}

TEST(TextEdit, AJsonObjectWhoseEntriesAllChangeTheirNames) {
  for (const char* bytes : {"{\"a\": 1, \"b\": 2}", "{\n  \"a\": 1,\n  \"b\": 2\n}\n"}) {
    Document document = document_of(bytes);
    const std::vector<Field> before = {fields::integer("a", 1), fields::integer("b", 2)};
    const std::vector<Field> after = {fields::integer("c", 3), fields::integer("d", 4)};
    fields::apply(document, document.root(), Dialect::kOpenCv, before, after);
    EXPECT_EQ(keys_of(document.bytes(), ""), "cd") << document.bytes();
  }
}

TEST(TextEdit, OneNumberChangesItsOwnBytesOnly) {
  Document json = document_of("{\"D\": [1.50, -2e0, 3]}\n");
  fields::apply(json, json.root(), Dialect::kOpenCv, {}, std::vector{fields::list("D", std::vector{1.5, -2.0, 4.0})});
  EXPECT_EQ(json.bytes(), "{\"D\": [1.50, -2e0, 4.0]}\n");
  Document xml = document_of("<opencv_storage><D>1.50\n -2. 3.</D><one>5.</one></opencv_storage>\n");
  fields::apply(xml, xml.root(), Dialect::kOpenCv, {},
                std::vector{fields::list("D", std::vector{1.5, -2.0, 4.0}), fields::list("one", std::vector{6.0})});
  EXPECT_EQ(xml.bytes(), "<opencv_storage><D>1.50\n -2. 4.0</D><one>6.0</one></opencv_storage>\n");
}

TEST(TextEdit, AMatrixOfOneNumberInXml) {
  const Document document = document_of(
      "<opencv_storage><xi type_id=\"opencv-matrix\"><rows>1</rows><cols>1</cols><dt>d</dt><data>\n  "
      "1.25</data></xi></opencv_storage>");
  Diagnostics diagnostics;
  fields::Reader reader(document, Dialect::kOpenCv, diagnostics);
  const auto matrix = reader.opencv_matrix(at(document, "xi"), "xi");
  ASSERT_TRUE(matrix);
  EXPECT_EQ(matrix->values, std::vector{1.25});
}

TEST(TextEdit, WordsAreSetOneByOne) {
  Parsed parsed = parse("#c\r\n2 1.50 3\r\n", "calib_results.txt");
  Document document = *parsed.document;
  fields::set_scalar(document, at(document, "1/1"), "1.5");
  EXPECT_FALSE(document.edited());
  fields::set_scalar(document, at(document, "1/2"), "2.0e-05");
  EXPECT_EQ(document.bytes(), "#c\r\n2 1.50 2.0e-05\r\n");
}

}  // namespace
}  // namespace fca::test
