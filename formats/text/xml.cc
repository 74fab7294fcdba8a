// SPDX-License-Identifier: BSD-3-Clause
// The only user of tinyxml2. It parses a copy of the text in place and never moves a name or a text, so the distance between
// two values' addresses is that of their bytes in the source; every one is compared with the source before it is believed.
#include "xml.h"

#include "markup.h"
#include "utf8.h"

#include <fca/formats/text/limits.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>

#include <tinyxml2.h>

namespace fca::text {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";
/// Stands before the text in what tinyxml2 gets: its value's address is the beginning of all.
constexpr std::string_view kPrefix = "<?fca?>";
constexpr std::size_t kPrefixValue = 2;

/// What stands between '&' and ';'. False if XML has no such entity.
bool append_entity(std::string& text, std::string_view name) {
  constexpr std::pair<std::string_view, char> kEntities[] = {
      {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
  for (const auto& [entity, character] : kEntities) {
    if (name != entity) continue;
    text += character;
    return true;
  }
  if (!name.starts_with('#')) return false;
  const bool hex = name.starts_with("#x");
  const std::string_view digits = name.substr(hex ? 2 : 1);
  unsigned code = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), code, hex ? 16 : 10);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (failure != std::errc() || end != digits.data() + digits.size() || code == 0 || code > 0x10FFFF || surrogate) return false;
  append_utf8(code, text);
  return true;
}

/// Of Metashape's files.
constexpr std::array<std::string_view, 2> kOtherRoots = {"calibration", "document"};

class TreeBuilder {
 public:
  explicit TreeBuilder(const Source& source) : source_(source), bytes_(source.bytes) {}

  Node build(const tinyxml2::XMLDocument& document) {
    const char* first = document.FirstChild()->Value();
    base_ = first - kPrefixValue;
    const tinyxml2::XMLElement* root = document.RootElement();
    const Span name = name_span(*root);
    const std::string_view called = source_.text(name);
    keeps_attributes_ = std::ranges::find(kOtherRoots, called) != kOtherRoots.end();
    if (called != "opencv_storage" && !keeps_attributes_) {
      constexpr std::size_t kLongest = 40;
      throw Refusal{{Code::kXmlRoot, {called.substr(0, kLongest)}}, name.offset};
    }
    Node node = value_of(*root, name);
    if (keeps_attributes_) node.tag = called;
    return node;
  }

 private:
  /// Where a string of tinyxml2's stands in the source.
  [[nodiscard]] std::size_t offset_of(const char* value) const {
    const std::size_t length = kPrefix.size() + bytes_.size() - source_.byte_order_mark();
    const std::less<> before;
    if (before(value, base_ + kPrefix.size()) || before(base_ + length, value)) refuse_place(source_.byte_order_mark());
    return static_cast<std::size_t>(value - base_) - kPrefix.size() + source_.byte_order_mark();
  }

  [[noreturn]] static void refuse_place(std::size_t offset) { throw Refusal{{Code::kXmlMisread}, offset}; }

  [[nodiscard]] Span name_span(const tinyxml2::XMLElement& element) const {
    const std::string_view name = element.Name();
    const Span span = {offset_of(element.Name()), name.size()};
    if (span.offset == 0 || bytes_[span.offset - 1] != '<' || source_.text(span) != name) refuse_place(span.offset);
    return span;
  }

  /// Text with its entities resolved and one kind of line break.
  [[nodiscard]] std::string resolved(const Span& span) const {
    std::string text;
    for (std::size_t i = span.offset; i < span.end(); ++i) {
      const char c = bytes_[i];
      if (c == '\r' || c == '\n') {
        text += '\n';
        // Either order, as tinyxml2 has it.
        if (i + 1 < span.end() && bytes_[i + 1] == (c == '\r' ? '\n' : '\r')) ++i;
      } else if (c == '&') {
        const std::size_t semicolon = bytes_.find(';', i);
        const bool known = semicolon < span.end() && append_entity(text, source_.text({i + 1, semicolon - i - 1}));
        if (!known) throw Refusal{{Code::kXmlUnknownEntity}, i};
        i = semicolon;
      } else {
        text += c;
      }
    }
    return text;
  }

  /// Adds a text as it stands, without the blanks around it.
  void add_text(const Span& whole, std::vector<Node>& items) const {
    const std::string_view text = source_.text(whole);
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return;
    Node node;
    node.kind = NodeKind::kScalar;
    node.span = {whole.offset + first, text.find_last_not_of(kBlanks) + 1 - first};
    node.value = resolved(node.span);
    items.push_back(std::move(node));
  }

  /// Adds the texts between `text`'s first and last byte to a sequence.
  void add_words(const tinyxml2::XMLText& text, std::vector<Node>& items) const {
    const std::size_t start = offset_of(text.Value());
    const Span whole = {start, std::min(bytes_.find('<', start), bytes_.size()) - start};
    if (resolved(whole) != text.Value()) refuse_place(start);
    if (keeps_attributes_) return add_text(whole, items);
    const std::string_view bytes = bytes_.substr(0, whole.end());
    std::size_t at = bytes.find_first_not_of(kBlanks, start);
    while (at < whole.end()) {
      Node node;
      node.kind = NodeKind::kScalar;
      node.quoted = bytes[at] == '"';
      std::size_t end = std::min(bytes.find_first_of(node.quoted ? std::string_view("\"") : kBlanks, at + 1), whole.end());
      if (node.quoted) {
        if (end == whole.end()) throw Refusal{{Code::kXmlQuoteOpen}, at};
        node.value = resolved({at + 1, end - at - 1});
        ++end;
        const bool separate = end == whole.end() || kBlanks.find(bytes[end]) != std::string_view::npos;
        if (!separate) throw Refusal{{Code::kXmlBlankMissing}, end};
      } else {
        const std::size_t quote = source_.text({at, end - at}).find('"');
        if (quote != std::string_view::npos) throw Refusal{{Code::kXmlQuoteInWord}, at + quote};
        node.value = resolved({at, end - at});
      }
      node.span = {at, end - at};
      if (items.size() == kLongestList) throw too_long(at);
      items.push_back(std::move(node));
      at = bytes.find_first_not_of(kBlanks, end);
    }
  }

  /// Those of an element, as entries before its own.
  void add_attributes(const tinyxml2::XMLElement& element, std::vector<Entry>& entries) const {
    for (const tinyxml2::XMLAttribute* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
      Entry entry;
      entry.key.kind = NodeKind::kScalar;
      entry.key.value = attribute(each->Name());
      entry.key.span = {offset_of(each->Name()), std::string_view(each->Name()).size()};
      entry.value.kind = NodeKind::kScalar;
      entry.value.value = each->Value();
      entry.value.quoted = true;
      entry.value.span = {offset_of(each->Value()), std::string_view(each->Value()).size()};
      entries.push_back(std::move(entry));
    }
  }

  // Recursive, but no deeper than kMaxDepth: check_markup has seen the document.
  // NOLINTNEXTLINE(misc-no-recursion)
  [[nodiscard]] Node value_of(const tinyxml2::XMLElement& element, const Span& name) const {
    Node node;
    bool has_item_elements = false;
    std::size_t first = std::string_view::npos;
    std::size_t last = 0;
    if (keeps_attributes_) add_attributes(element, node.entries);
    const std::size_t attributes = node.entries.size();
    for (const tinyxml2::XMLNode* child = element.FirstChild(); child != nullptr; child = child->NextSibling()) {
      if (const tinyxml2::XMLText* text = child->ToText()) {
        const std::size_t before = node.items.size();
        add_words(*text, node.items);
        if (node.items.size() == before) continue;
        first = std::min(first, node.items[before].span.offset);
        last = node.items.back().span.end();
      } else if (const tinyxml2::XMLElement* inner = child->ToElement()) {
        const Span inner_name = name_span(*inner);
        if (std::max(node.items.size(), node.entries.size()) == kLongestList) throw too_long(inner_name.offset);
        Node value = value_of(*inner, inner_name);
        const Span span = element_span(bytes_, inner_name);
        first = std::min(first, span.offset);
        last = span.end();
        if (source_.text(inner_name) == "_") {
          has_item_elements = true;
          node.items.push_back(std::move(value));
        } else {
          Node key;
          key.kind = NodeKind::kScalar;
          key.span = inner_name;
          key.value = inner->Name();
          node.entries.push_back({std::move(key), std::move(value)});
        }
      } else if (child->ToComment() == nullptr) {
        refuse_place(name.offset);
      }
    }
    // The attributes of a text are not kept.
    if (!node.items.empty() && node.entries.size() == attributes) node.entries.clear();
    if (!node.entries.empty() && !node.items.empty()) throw Refusal{{Code::kXmlMixed, {source_.text(name)}}, name.offset};
    if (node.items.size() == 1 && !has_item_elements) {
      node = Node(std::move(node.items.front()));
    } else if (!node.items.empty()) {
      node.kind = NodeKind::kSequence;
    } else if (!node.entries.empty()) {
      node.kind = NodeKind::kMapping;
    }
    if (!node.is_scalar() && first == std::string_view::npos && !node.entries.empty()) {
      node.span = name;
    } else if (!node.is_scalar()) {
      const std::size_t content = next_markup(bytes_, name.offset - 1).value_or(Markup{}).span.end();
      node.span = node.kind == NodeKind::kNull ? Span{content, 0} : Span{first, last - first};
    }
    if (const char* type = element.Attribute("type_id")) node.tag = std::string("tag:yaml.org,2002:") + type;
    return node;
  }

  const Source& source_;
  std::string_view bytes_;
  const char* base_ = nullptr;
  bool keeps_attributes_ = false;
};

/// Of tinyxml2 only the line is known.
Refusal describe(const tinyxml2::XMLDocument& document, const Source& source) {
  std::size_t offset = source.byte_order_mark();
  for (int line = 1; line < document.ErrorLineNum(); ++line) {
    const std::size_t newline = source.bytes.find('\n', offset);
    if (newline == std::string::npos) break;
    offset = newline + 1;
  }
  const std::size_t content = source.bytes.find_first_not_of(kBlanks, offset);
  if (content < source.line_at(offset).end()) offset = content;
  const bool attribute = document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ATTRIBUTE;
  return {{attribute ? Code::kXmlAttribute : Code::kXmlLine}, offset};
}

}  // namespace

std::optional<Node> parse_xml(const Source& source, Diagnostics& diagnostics) {
  std::optional<Refusal> problem = find_conflict_marker(source);
  if (!problem) problem = check_markup(source);
  if (problem) {
    report(*problem, source, diagnostics);
    return std::nullopt;
  }
  const std::string text = std::string(kPrefix) + source.bytes.substr(source.byte_order_mark());
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    report(describe(document, source), source, diagnostics);
    return std::nullopt;
  }
  try {
    return TreeBuilder(source).build(document);
  } catch (const Refusal& refusal) {
    report(refusal, source, diagnostics);
    return std::nullopt;
  }
}

}  // namespace fca::text
