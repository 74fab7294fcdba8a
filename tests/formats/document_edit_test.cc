// SPDX-License-Identifier: BSD-3-Clause
// Edits change the bytes they name and no other.
#include "formats/test_files.h"

#include <fca/formats/text/read_document.h>

#include <functional>
#include <random>

namespace fca::test {
namespace {

using text::Document;
using text::Node;

/// The document of a good file, and its bytes after an edit as one of the same syntax.
Document open(const fs::path& path) { return document_of(read_file(path), path.filename().string()); }
Document reopened(const fs::path& path, const Document& edited) {
  return document_of(edited.bytes(), path.filename().string());
}

/// Plain numbers: values that may be replaced by another number wherever they stand.
std::vector<const Node*> numbers_of(const Document& document) {
  std::vector<const Node*> numbers;
  for (const Node* scalar : scalars_of(document)) {
    if (!scalar->quoted && scalar->value.find_first_not_of("0123456789+-.eE") == std::string::npos) numbers.push_back(scalar);
  }
  return numbers;
}

std::vector<std::string> values_of(const Document& document) {
  std::vector<std::string> values;
  for (const Node* scalar : scalars_of(document)) values.push_back(scalar->value);
  return values;
}

TEST(DocumentEdit, NoEditIsTheSameBytes) {
  for (const fs::path& path : files_of_all_formats("good")) {
    const std::string bytes = read_file(path);
    const Document document = open(path);
    EXPECT_FALSE(document.edited());
    EXPECT_EQ(document.bytes(), bytes) << path;
  }
}

TEST(DocumentEdit, OneValueChangesItsOwnBytes) {
  for (const fs::path& path : files_of_all_formats("good")) {
    const std::string bytes = read_file(path);
    const Document original = open(path);
    for (const Node* number : numbers_of(original)) {
      Document document = original;
      document.replace(number->span, "-123.456789");
      EXPECT_TRUE(document.edited());
      const std::string expected = bytes.substr(0, number->span.offset) + "-123.456789" + bytes.substr(number->span.end());
      ASSERT_EQ(document.bytes(), expected) << path;
    }
  }
}

// In any order, many at once: reading back gives the new values at those places and the old ones everywhere else.
TEST(DocumentEdit, RandomEditsReadBack) {
  std::mt19937 random(7);
  for (const fs::path& path : files_of_all_formats("good")) {
    for (int round = 0; round < 20; ++round) {
      Document document = open(path);
      if (document.syntax() == text::Syntax::kBinary) continue;  // its words are no text
      std::vector<const Node*> scalars = scalars_of(document);
      std::vector<const Node*> numbers = numbers_of(document);
      std::ranges::shuffle(numbers, random);
      if (numbers.empty()) continue;
      numbers.resize(1 + random() % numbers.size());
      std::vector<std::string> expected = values_of(document);
      for (const Node* number : numbers) {
        const std::string value = std::to_string(random() % 1000) + ".25";
        const auto index = static_cast<std::size_t>(std::ranges::find(scalars, number) - scalars.begin());
        expected[index] = value;
        document.replace(number->span, value);
      }
      ASSERT_EQ(values_of(reopened(path, document)), expected) << path;
    }
  }
}

TEST(DocumentEdit, WhatIsKeptIsWhatTheLastEditLeft) {
  for (const fs::path& path : files_of_all_formats("good")) {
    Document document = open(path);
    const Document original = document;
    if (document.syntax() == text::Syntax::kBinary) continue;  // its words are no text
    for (const Node* number : numbers_of(original)) {
      document.replace(number->span, "7.125");
      keep_edited(document);
      ASSERT_NE(document.kept_edited(), nullptr);
      ASSERT_EQ(values_of(as_edited(document).value()), values_of(reopened(path, document))) << path;
    }
  }
}

TEST(DocumentEdit, EveryEditForgetsWhatWasKept) {
  for (const std::string bytes : {"a: 1\nb: 2\n", "{a: 1, b: 2}\n"}) {
    const auto keeps_after = [&bytes](const std::function<void(Document&, const Node&)>& edit) {
      const Document original = document_of(bytes);
      Document document = original;
      document.replace(at(original, "a").span, "3");
      keep_edited(document);
      edit(document, original.root());
      return document.kept_edited() != nullptr;
    };
    EXPECT_TRUE(keeps_after([](Document&, const Node&) {}));
    EXPECT_FALSE(keeps_after([](Document& document, const Node&) { document.insert(0, " "); }));
    EXPECT_FALSE(keeps_after([](Document& document, const Node& root) { document.remove_entry(root, entry_at(root, "b")); }));
    EXPECT_FALSE(
        keeps_after([](Document& document, const Node& root) { document.insert_after(root, entry_at(root, "b"), "c: 4"); }));
  }
}

TEST(DocumentEdit, InsertAfterKeepsIndentationAndLineBreaks) {
  for (const std::string line_break : {"\n", "\r\n"}) {
    const auto lines = [&line_break](std::initializer_list<const char*> all) {
      std::string text;
      for (const char* line : all) text += line + line_break;
      return text;
    };
    Document document =
        document_of(lines({"cam0:", "    a: 1   # first", "    rows:", "    - [1, 2]", "    - [3, 4]", "b: 2"}));
    const Node& camera = at(document, "cam0");
    document.insert_after(camera, entry_at(camera, "a"), "new: 5");
    document.insert_after(camera, entry_at(camera, "rows"), "more:\n  - 6");
    document.insert_after(document.root(), entry_at(document.root(), "b"), "last: 7");
    EXPECT_EQ(document.bytes(), lines({"cam0:", "    a: 1   # first", "    new: 5", "    rows:", "    - [1, 2]", "    - [3, 4]",
                                       "    more:", "      - 6", "b: 2", "last: 7"}));
  }
}

TEST(DocumentEdit, InsertAfterTheLastLineWithoutItsBreak) {
  Document document = document_of("a: 1\nb: 2");
  document.insert_after(document.root(), entry_at(document.root(), "b"), "c: 3");
  EXPECT_EQ(document.bytes(), "a: 1\nb: 2\nc: 3");
  EXPECT_EQ(at(document_of(document.bytes()), "c").value, "3");
}

TEST(DocumentEdit, InsertionsAtOnePlaceKeepTheirOrder) {
  Document document = document_of("a: 1\nz: 2\n");
  document.insert_after(document.root(), entry_at(document.root(), "a"), "b: 1");
  document.insert_after(document.root(), entry_at(document.root(), "a"), "c: 2");
  EXPECT_EQ(document.bytes(), "a: 1\nb: 1\nc: 2\nz: 2\n");
}

TEST(DocumentEdit, RemoveEntryTakesItsLinesOnly) {
  for (const std::string line_break : {"\n", "\r\n"}) {
    const auto lines = [&line_break](std::initializer_list<const char*> all) {
      std::string text;
      for (const char* line : all) text += line + line_break;
      return text;
    };
    const std::string bytes = lines({"# head", "cam0:", "  a: 1 # gone with its comment", "  T:", "  - [1, 2]", "  - [3,",
                                     "     4] # end", "  z: 9", "# tail"});
    Document without_T = document_of(bytes);
    without_T.remove_entry(at(without_T, "cam0"), entry_at(at(without_T, "cam0"), "T"));
    EXPECT_EQ(without_T.bytes(), lines({"# head", "cam0:", "  a: 1 # gone with its comment", "  z: 9", "# tail"}));
    Document without_a = document_of(bytes);
    without_a.remove_entry(at(without_a, "cam0"), entry_at(at(without_a, "cam0"), "a"));
    EXPECT_EQ(without_a.bytes(),
              lines({"# head", "cam0:", "  T:", "  - [1, 2]", "  - [3,", "     4] # end", "  z: 9", "# tail"}));
  }
}

TEST(DocumentEdit, RemoveEntryWithoutAValueAndAtTheEnd) {
  Document document = document_of("a:\nb: 2\nc: 3");
  document.remove_entry(document.root(), entry_at(document.root(), "a"));
  document.remove_entry(document.root(), entry_at(document.root(), "c"));
  EXPECT_EQ(document.bytes(), "b: 2\n");
}

// Document says "of a block mapping". A caller that forgets must not get a file that says something else without notice.
TEST(DocumentEdit, WhatWasInsertedCanBeRemoved) {
  for (const fs::path& path : files_of_all_formats("good")) {
    const std::string bytes = read_file(path);
    const bool yaml = path.extension() == ".yaml" || path.extension() == ".yml";
    if (!yaml || !bytes.ends_with('\n')) continue;
    Document document = open(path);
    if (document.root().flow) continue;
    document.insert_after(document.root(), document.root().entries.front(), "inserted:\n  - [1.0, 2.0]");
    Document again = document_of(document.bytes());
    again.remove_entry(again.root(), entry_at(again.root(), "inserted"));
    EXPECT_EQ(again.bytes(), bytes) << path;
  }
}

}  // namespace
}  // namespace fca::test
