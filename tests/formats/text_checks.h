// SPDX-License-Identifier: BSD-3-Clause
// What holds for the tree of every syntax.
#pragma once

#include "formats/test_files.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <random>

namespace fca::test {

/// XML's entities, by replacement.
inline std::string without_entities(std::string text) {
  const std::pair<const char*, const char*> kEntities[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}};
  for (const auto& [entity, character] : kEntities) {
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
      text.replace(at, std::string(entity).size(), character);
  }
  return text;
}

/// JSON's escapes but \u.
inline std::string without_escapes(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      result += text[i];
      continue;
    }
    const char c = text[++i];
    const std::size_t control = std::string("bfnrt").find(c);
    result += control == std::string::npos ? c : "\b\f\n\r\t"[control];
  }
  return result;
}

/// Is it the name or the value of an attribute of XML, which stand in a tag?
inline bool is_of_attribute(const text::Document& document, const text::Node& scalar) {
  const std::string& bytes = document.source().bytes;
  const char before = scalar.span.offset > 0 ? bytes[scalar.span.offset - 1] : ' ';
  const char behind = scalar.span.end() < bytes.size() ? bytes[scalar.span.end()] : ' ';
  return scalar.value.starts_with('@') || ((before == '"' || before == '\'') && behind == before);
}

/// The bytes at every scalar's span, with their quotes off and escapes resolved, are its value; spans ascend. Returns how many.
inline int expect_scalar_spans(const text::Document& document) {
  std::size_t behind = 0;
  int count = 0;
  for (const text::Node* scalar : scalars_of(document)) {
    std::string spelled(document.source().text(scalar->span));
    EXPECT_GE(scalar->span.offset, behind) << spelled;
    behind = scalar->span.end();
    if (document.syntax() == text::Syntax::kPython) {  // a string may have a prefix, and be several
      if (!scalar->quoted) {
        EXPECT_TRUE(spelled == scalar->value || spelled == "True" || spelled == "False") << spelled;
      } else {
        EXPECT_TRUE(spelled.ends_with('\'') || spelled.ends_with('"')) << spelled;
        const bool is_plain = spelled.find_first_of("\\\n") == std::string::npos;
        EXPECT_TRUE(!is_plain || spelled.find(scalar->value) != std::string::npos) << spelled;
      }
      ++count;
      continue;
    }
    if (document.syntax() == text::Syntax::kXml && is_of_attribute(document, *scalar)) {
      EXPECT_EQ(without_entities(spelled), scalar->value.substr(scalar->value.starts_with('@') ? 1 : 0));
      ++count;
      continue;
    }
    if (scalar->quoted) {
      EXPECT_GE(spelled.size(), 2U);
      EXPECT_EQ(spelled.front(), '"');
      EXPECT_EQ(spelled.back(), '"');
      spelled = spelled.substr(1, spelled.size() - 2);
    }
    if (document.syntax() == text::Syntax::kJson && scalar->quoted) spelled = without_escapes(spelled);
    if (document.syntax() == text::Syntax::kXml) spelled = without_entities(spelled);
    EXPECT_EQ(spelled, scalar->value);
    ++count;
  }
  return count;
}

/// Every node's span lies within the one that holds it.
inline void expect_nested_spans(const text::Node& node, std::size_t size) {
  EXPECT_LE(node.span.end(), size);
  const auto within = [&node](const text::Node& inner) {
    EXPECT_GE(inner.span.offset, node.span.offset);
    EXPECT_LE(inner.span.end(), node.span.end());
  };
  for (const text::Node& item : node.items) {
    within(item);
    expect_nested_spans(item, size);
  }
  for (const text::Entry& entry : node.entries) {
    if (entry.key.value.starts_with('@')) continue;  // an attribute of XML stands in the tag
    within(entry.key);
    within(entry.value);
    expect_nested_spans(entry.value, size);
  }
}

/// Numbers replaced at random change these bytes and no others, and are what is then read there.
inline void expect_edits_stay_in_their_place(const text::Document& document, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<const text::Node*> numbers;
  for (const text::Node* scalar : scalars_of(document)) {
    const bool number = !scalar->quoted && text::parse_real(scalar->value).has_value();
    if (number) numbers.push_back(scalar);
  }
  if (numbers.empty()) return;
  text::Document edited = document;
  std::string wanted = document.source().bytes;
  std::vector<std::size_t> changed;
  for (int i = 0; i < 5; ++i) changed.push_back(random() % numbers.size());
  std::ranges::sort(changed, std::greater());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for (const std::size_t index : changed) {
    const text::Span span = numbers[index]->span;
    edited.replace(span, "12345.5");
    wanted.replace(span.offset, span.length, "12345.5");
  }
  EXPECT_EQ(edited.bytes(), wanted);
  const Parsed again = parse(edited.bytes(), document.source().name);
  ASSERT_TRUE(again.document) << again.rendered();
  const std::vector<const text::Node*> after = scalars_of(*again.document);
  const auto said = std::ranges::count_if(after, [](const text::Node* scalar) { return scalar->value == "12345.5"; });
  EXPECT_GE(said, static_cast<std::ptrdiff_t>(changed.size()));
}

/// Cut off anywhere, the text is a document with sound spans or is refused in words at a place inside it.
inline void expect_truncations_are_harmless(const std::string& bytes, const std::string& name) {
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const Parsed parsed = parse(bytes.substr(0, length), name);
    if (parsed.document) {
      expect_nested_spans(parsed.document->root(), length);
    } else {
      ASSERT_FALSE(parsed.diagnostics.entries().empty()) << length;
      EXPECT_FALSE(message_of(parsed.diagnostics.entries().front()).empty());
      EXPECT_LE(parsed.diagnostics.entries().front().where.offset, length);
    }
  }
}

/// "line:column code" of the only diagnostic.
inline std::string place_and_code(const std::string& bytes, const std::string& name) {
  const Parsed parsed = parse(bytes, name);
  if (parsed.document) return "no error";
  if (parsed.diagnostics.entries().size() != 1) return "several errors";
  const Diagnostic& entry = parsed.diagnostics.entries().front();
  return place_of(entry.where, parsed.source) + " " + id_of(entry);
}

}  // namespace fca::test
