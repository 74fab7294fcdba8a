// SPDX-License-Identifier: BSD-3-Clause
// The only user of RapidJSON in the text layer. It tells where a string ends; where any token begins follows from the end of
// the one before, because only blanks, a comma and a colon can stand between two. Every token is compared with the source.
#include "json.h"

#include "refusal.h"

#include <fca/formats/text/limits.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include <rapidjson/error/en.h>
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

namespace fca::text {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kBetweenTokens = " \t\r\n,:";

/// Builds the tree from RapidJSON's events. A method that returns false ends the parse; the reason is in `refusal()`.
class TreeBuilder {
 public:
  TreeBuilder(const Source& source, const rapidjson::MemoryStream& stream)
      : source_(source), stream_(stream), last_end_(source.byte_order_mark()) {}

  [[nodiscard]] Node take_root() { return std::move(root_); }
  [[nodiscard]] const std::optional<Refusal>& refusal() const { return refusal_; }
  [[nodiscard]] std::size_t last_end() const { return last_end_; }
  /// The bracket of the innermost collection that is still open.
  [[nodiscard]] std::optional<std::size_t> open_bracket() const {
    if (stack_.empty()) return std::nullopt;
    return stack_.back().node.span.offset;
  }

  // RapidJSON's names.
  // NOLINTBEGIN(readability-identifier-naming)
  bool Null() { return add_word(NodeKind::kNull, "null"); }
  bool Bool(bool value) { return add_word(NodeKind::kScalar, value ? "true" : "false"); }
  bool RawNumber(const char* text, rapidjson::SizeType length, bool /*copy*/) {
    return add_word(NodeKind::kScalar, {text, length});
  }
  bool String(const char* text, rapidjson::SizeType length, bool /*copy*/) {
    Node node;
    return string({text, length}, node) && add(std::move(node));
  }
  bool Key(const char* text, rapidjson::SizeType length, bool /*copy*/) { return string({text, length}, stack_.back().key); }
  bool StartObject() { return open(NodeKind::kMapping, '{'); }
  bool EndObject(rapidjson::SizeType /*count*/) { return close('}'); }
  bool StartArray() { return open(NodeKind::kSequence, '['); }
  bool EndArray(rapidjson::SizeType /*count*/) { return close(']'); }
  // Numbers come as strings.
  bool Int(int /*value*/) { return false; }
  bool Uint(unsigned /*value*/) { return false; }
  bool Int64(std::int64_t /*value*/) { return false; }
  bool Uint64(std::uint64_t /*value*/) { return false; }
  bool Double(double /*value*/) { return false; }
  // NOLINTEND(readability-identifier-naming)

 private:
  struct Open {
    Node node;
    Node key;
  };

  [[nodiscard]] std::size_t next_token() const {
    return std::min(source_.bytes.find_first_not_of(kBetweenTokens, last_end_), source_.bytes.size());
  }

  bool refuse(Refusal refusal) {
    refusal_ = std::move(refusal);
    return false;
  }
  bool refuse_place(std::size_t offset) { return refuse({{Code::kJsonMisread}, offset}); }

  bool add_word(NodeKind kind, std::string_view word) {
    Node node;
    node.kind = kind;
    node.span = {next_token(), word.size()};
    if (source_.text(node.span) != word) return refuse_place(node.span.offset);
    if (kind == NodeKind::kScalar) node.value = word;
    last_end_ = node.span.end();
    return add(std::move(node));
  }

  bool string(std::string_view value, Node& node) {
    const std::size_t start = next_token();
    const std::size_t end = source_.byte_order_mark() + stream_.Tell();
    const std::string_view bytes = source_.bytes;
    const bool quotes = end >= start + 2 && end <= bytes.size() && bytes[start] == '"' && bytes[end - 1] == '"';
    if (!quotes) return refuse_place(start);
    const std::string_view inner = bytes.substr(start + 1, end - start - 2);
    if (inner.find('\\') == std::string_view::npos && inner != value) return refuse_place(start);
    node = Node();
    node.kind = NodeKind::kScalar;
    node.quoted = true;
    node.value = value;
    node.span = {start, end - start};
    last_end_ = end;
    return true;
  }

  bool open(NodeKind kind, char bracket) {
    const std::size_t start = next_token();
    if (start >= source_.bytes.size() || source_.bytes[start] != bracket) return refuse_place(start);
    if (stack_.size() >= static_cast<std::size_t>(kMaxDepth)) return refuse(too_deep(start));
    Open opened;
    opened.node.kind = kind;
    opened.node.flow = true;
    opened.node.span = {start, 0};
    if (!stack_.empty()) opened.key = {};
    stack_.push_back(std::move(opened));
    last_end_ = start + 1;
    return true;
  }

  bool close(char bracket) {
    const std::size_t at = std::min(source_.bytes.find_first_not_of(kBlanks, last_end_), source_.bytes.size());
    if (at >= source_.bytes.size() || source_.bytes[at] != bracket) return refuse_place(at);
    Node node = std::move(stack_.back().node);
    stack_.pop_back();
    last_end_ = at + 1;
    node.span.length = last_end_ - node.span.offset;
    const auto type = std::ranges::find_if(node.entries, [](const Entry& entry) { return entry.key.value == "type_id"; });
    if (type != node.entries.end() && type->value.quoted) node.tag = "tag:yaml.org,2002:" + type->value.value;
    return add(std::move(node));
  }

  bool add(Node node) {
    if (stack_.empty()) {
      root_ = std::move(node);
    } else if (Open& parent = stack_.back(); std::max(parent.node.entries.size(), parent.node.items.size()) == kLongestList) {
      return refuse(too_long(node.span.offset));
    } else if (parent.node.is_mapping()) {
      parent.node.entries.push_back({std::move(parent.key), std::move(node)});
    } else {
      parent.node.items.push_back(std::move(node));
    }
    return true;
  }

  const Source& source_;
  const rapidjson::MemoryStream& stream_;
  std::size_t last_end_;
  std::vector<Open> stack_;
  Node root_;
  std::optional<Refusal> refusal_;
};

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '+' || c == '-' || c == '.';
}

/// What stands at `offset`, where no value can be.
Message describe_value(std::string_view bytes, std::size_t offset) {
  std::size_t end = offset;
  while (end < bytes.size() && is_word_character(bytes[end])) ++end;
  std::string word(bytes.substr(offset, end - offset));
  std::string letters;
  for (const char c : word) {
    if (c != '.' && c != '+' && c != '-') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (letters == "nan" || letters == "inf" || letters == "infinity") return {Code::kJsonNotANumber};
  const char first = bytes[offset];
  if (first == '+') return {Code::kJsonPlus};
  if (first == '.') return {Code::kJsonPointFirst};
  if (first == '-' && word.size() > 1) return {Code::kJsonNoNumber};
  if (word.empty()) return {Code::kJsonValueMissing};
  constexpr std::size_t kLongest = 40;
  return {Code::kJsonNoValue, {word.substr(0, kLongest)}};
}

/// RapidJSON's error for the owner of the file, at the place that needs the fix.
Refusal describe(rapidjson::ParseErrorCode code, std::size_t offset, const TreeBuilder& builder, const Source& source) {
  const std::string_view bytes = source.bytes;
  const auto refusal = [](Code what, std::size_t at) { return Refusal{{what}, at}; };
  const std::size_t token = std::min(bytes.find_first_not_of(kBetweenTokens, builder.last_end()), bytes.size());
  const bool in_string = token < bytes.size() && bytes[token] == '"' && offset > token;
  if (code == rapidjson::kParseErrorStringMissQuotationMark) return refusal(Code::kJsonStringOpen, token);
  if (in_string) {
    const char c = offset < bytes.size() ? bytes[offset] : '\0';
    if (c == '\n' || c == '\r') return refusal(Code::kJsonStringOfLines, token);
    if (static_cast<unsigned char>(c) < 0x20) return refusal(Code::kJsonControlCharacter, offset);
    const bool encoding = code == rapidjson::kParseErrorStringInvalidEncoding;
    return refusal(encoding ? Code::kJsonNotUtf8 : Code::kJsonWrongEscape, offset);
  }

  // Words are reported where they begin, not where RapidJSON gave up.
  if (code == rapidjson::kParseErrorValueInvalid || code == rapidjson::kParseErrorNumberMissFraction ||
      code == rapidjson::kParseErrorNumberMissExponent) {
    while (offset > builder.last_end() && is_word_character(bytes[offset - 1])) --offset;
  }
  if (offset >= bytes.size()) {
    if (const std::optional<std::size_t> open = builder.open_bracket())
      return {{Code::kJsonBracketOpen, {bytes.substr(*open, 1)}}, *open};
    return refusal(Code::kJsonEndsEarly, bytes.empty() ? 0 : bytes.size() - 1);
  }
  const char c = bytes[offset];
  const std::size_t before = offset == 0 ? std::string_view::npos : bytes.find_last_not_of(kBlanks, offset - 1);
  const char previous = before == std::string_view::npos ? '\0' : bytes[before];
  if ((c == '}' || c == ']') && previous == ',') return refusal(Code::kJsonCommaAfterLast, before);
  if (c == '\'') return refusal(Code::kJsonSingleQuotes, offset);
  if (c == '/' || c == '#') return refusal(Code::kJsonComment, offset);
  switch (code) {
    case rapidjson::kParseErrorDocumentRootNotSingular:
      return refusal(Code::kJsonAfterRoot, offset);
    case rapidjson::kParseErrorObjectMissName:
      return refusal(Code::kJsonKeyWanted, offset);
    case rapidjson::kParseErrorObjectMissColon:
      return refusal(Code::kJsonColonMissing, offset);
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket: {
      const bool digits = previous == '0' && before + 1 == offset && std::isdigit(static_cast<unsigned char>(c)) != 0;
      if (digits) return refusal(Code::kJsonLeadingZeros, before);
      const bool object = code == rapidjson::kParseErrorObjectMissCommaOrCurlyBracket;
      return {{Code::kJsonCommaMissing, {object ? "}" : "]"}}, offset};
    }
    case rapidjson::kParseErrorNumberMissFraction:
      return refusal(Code::kJsonPointLast, offset);
    case rapidjson::kParseErrorNumberMissExponent:
      return refusal(Code::kJsonExponentEmpty, offset);
    case rapidjson::kParseErrorNumberTooBig:
      return refusal(Code::kJsonNumberTooBig, offset);
    case rapidjson::kParseErrorValueInvalid:
      return {describe_value(bytes, offset), offset};
    default:
      return {{Code::kJsonSyntax, {rapidjson::GetParseError_En(code)}}, offset};
  }
}

}  // namespace

std::optional<Node> parse_json(const Source& source, Diagnostics& diagnostics) {
  if (const std::optional<Refusal> conflict = find_conflict_marker(source)) {
    report(*conflict, source, diagnostics);
    return std::nullopt;
  }
  const std::size_t skipped = source.byte_order_mark();
  rapidjson::MemoryStream stream(source.bytes.data() + skipped, source.bytes.size() - skipped);
  TreeBuilder builder(source, stream);
  rapidjson::Reader reader;
  constexpr unsigned kFlags =
      rapidjson::kParseIterativeFlag | rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseValidateEncodingFlag;
  const rapidjson::ParseResult result = reader.Parse<kFlags>(stream, builder);
  if (!result.IsError()) return builder.take_root();
  report(builder.refusal() ? *builder.refusal() : describe(result.Code(), skipped + result.Offset(), builder, source), source,
         diagnostics);
  return std::nullopt;
}

}  // namespace fca::text
