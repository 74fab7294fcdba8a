// SPDX-License-Identifier: BSD-3-Clause
#include "mutations.h"

#include <array>
#include <optional>
#include <vector>

namespace fca::test {

namespace {

using text::Document;
using text::Node;
using text::Span;

/// The places of a document, by what can be done there.
struct Places {
  std::vector<Span> keys;
  std::vector<Span> values;  ///< Scalars, quotes included.
  std::vector<Span> parts;   ///< Entries of mappings and items of sequences, whole.
};

// Recursive, but no deeper than text::kMaxDepth.
void collect(const Document& document, const Node& node, Places& places) {
  if (node.is_scalar() && node.span.length > 0) places.values.push_back(node.span);
  for (const Node& item : node.items) {
    places.parts.push_back(item.span);
    collect(document, item, places);
  }
  for (const text::Entry& entry : node.entries) {
    places.keys.push_back(entry.key.span);
    places.parts.push_back(document.extent(entry));
    collect(document, entry.value, places);
  }
}

using Mutator = std::optional<std::string> (*)(const Document& document, const Places& places, std::mt19937& random);

const Span* any(const std::vector<Span>& spans, std::mt19937& random) {
  return spans.empty() ? nullptr : &spans[random() % spans.size()];
}

std::string with(const Document& document, const Span& span, const std::string& text) {
  std::string bytes = document.source().bytes;
  return bytes.replace(span.offset, span.length, text);
}

std::string text_of(const Document& document, const Span& span) { return std::string(document.source().text(span)); }

/// A letter lost, doubled, exchanged with its neighbour, in the other case, or another one.
std::optional<std::string> misspelt(const Document& document, const Places& places, std::mt19937& random) {
  const Span* key = any(places.keys, random);
  if (key == nullptr || key->length == 0) return std::nullopt;
  std::string name = text_of(document, *key);
  const std::size_t at = random() % name.size();
  switch (random() % 5) {
    case 0:
      name.erase(at, 1);
      break;
    case 1:
      name.insert(at, 1, name[at]);
      break;
    case 2:
      std::swap(name[at], name[(at + 1) % name.size()]);
      break;
    case 3:
      name[at] = static_cast<char>(name[at] ^ 0x20);
      break;
    default:
      name[at] = static_cast<char>('a' + random() % 26);
  }
  return with(document, *key, name);
}

std::optional<std::string> lost(const Document& document, const Places& places, std::mt19937& random) {
  const Span* part = any(places.parts, random);
  if (part == nullptr) return std::nullopt;
  return with(document, *part, "");
}

std::optional<std::string> doubled(const Document& document, const Places& places, std::mt19937& random) {
  const Span* part = any(places.parts, random);
  if (part == nullptr) return std::nullopt;
  constexpr std::array<const char*, 4> kSeparators = {"\n", ", ", " ", ""};
  const std::string text = text_of(document, *part);
  return with(document, *part, text + kSeparators.at(random() % kSeparators.size()) + text);
}

/// The later of two places takes the text of the earlier, and the other way round.
std::optional<std::string> exchanged_in(const Document& document, const std::vector<Span>& spans, std::mt19937& random) {
  const Span* a = any(spans, random);
  const Span* b = any(spans, random);
  if (a == nullptr || b == nullptr) return std::nullopt;
  if (b->offset < a->offset) std::swap(a, b);
  if (a->end() > b->offset) return std::nullopt;
  const std::string first = text_of(document, *a);
  std::string bytes = with(document, *b, first);
  return bytes.replace(a->offset, a->length, text_of(document, *b));
}

std::optional<std::string> values_exchanged(const Document& document, const Places& places, std::mt19937& random) {
  return exchanged_in(document, places.values, random);
}

std::optional<std::string> parts_exchanged(const Document& document, const Places& places, std::mt19937& random) {
  return exchanged_in(document, places.parts, random);
}

std::optional<std::string> other_kind(const Document& document, const Places& places, std::mt19937& random) {
  constexpr std::array<const char*, 16> kKinds = {"[]", "{}",   "",  "~",  "\"\"",   "[[1.0]]", "{a: 1}",  "true",
                                                  "-0", "1e-9", "0", "-1", "100000", "3",       "\"2.0\"", "<a/>"};
  const Span* value = any(places.values, random);
  if (value == nullptr) return std::nullopt;
  return with(document, *value, kKinds.at(random() % kKinds.size()));
}

/// A blank more or less before a line: in YAML it belongs to something else then.
std::optional<std::string> indented(const Document& document, const Places& places, std::mt19937& random) {
  const Span* part = any(places.parts, random);
  if (part == nullptr) return std::nullopt;
  const text::Span line = document.source().line_at(part->offset);
  if (random() % 2 == 0) return with(document, {line.offset, 0}, "  ");
  const bool blank = line.length > 1 && document.source().text({line.offset, 2}) == "  ";
  return blank ? std::optional(with(document, {line.offset, 2}, "")) : std::nullopt;
}

struct Row {
  const char* what;
  Mutator mutate;
};

constexpr std::array kRows = {Row{"a key misspelt", misspelt},
                              Row{"a part lost", lost},
                              Row{"a part doubled", doubled},
                              Row{"two values exchanged", values_exchanged},
                              Row{"two parts exchanged", parts_exchanged},
                              Row{"another kind of value", other_kind},
                              Row{"a line indented otherwise", indented}};

}  // namespace

Mutation mutated_structure(const Document& document, std::mt19937& random) {
  Places places;
  collect(document, document.root(), places);
  for (;;) {
    const Row& row = kRows.at(random() % kRows.size());
    if (std::optional<std::string> bytes = row.mutate(document, places, random)) return {row.what, *std::move(bytes)};
  }
}

}  // namespace fca::test
