// SPDX-License-Identifier: BSD-3-Clause
#include "python.h"

#include "python_string.h"
#include "refusal.h"

#include <fca/formats/text/limits.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace fca::text {

namespace {

constexpr std::string_view kBlanks = " \t\r\n\f";

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' || c == '-';
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes digits from the front; how many there were.
std::size_t take_digits(std::string_view& text) {
  const auto count = static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
  text.remove_prefix(count);
  return count;
}

/// "1", "-1.", ".5e-3", but not "017".
bool is_decimal(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::string_view whole = text;
  const std::size_t before = take_digits(text);
  std::size_t behind = 0;
  const bool has_point = text.starts_with('.');
  if (has_point) {
    text.remove_prefix(1);
    behind = take_digits(text);
  }
  if (before + behind == 0) return false;
  if (text.empty()) {
    const bool zeros = whole.find_first_not_of('0') == std::string_view::npos;
    return has_point || before == 1 || zeros || whole[0] != '0';
  }
  if (text[0] != 'e' && text[0] != 'E') return false;
  text.remove_prefix(1);
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return take_digits(text) > 0 && text.empty();
}

bool can_begin_number(char c) { return is_digit(c) || c == '.' || c == '+' || c == '-'; }

/// Recursive, but no deeper than kMaxDepth. A function that returns false has set `refusal()`.
class Parser {
 public:
  explicit Parser(const Source& source) : bytes_(source.bytes), at_(source.byte_order_mark()) {}

  bool parse(Node& root) {
    if (!parse_value(root)) return false;
    skip_blanks();
    return at_ == bytes_.size() || refuse(Code::kLiteralAfterRoot, at_);
  }
  [[nodiscard]] const Refusal& refusal() const { return refusal_; }

 private:
  bool refuse(Code code, std::size_t offset, std::vector<Argument> arguments = {}) {
    refusal_ = {{code, std::move(arguments)}, offset};
    return false;
  }

  /// What the end of the file cuts off.
  bool refuse_end() {
    if (open_.empty()) return refuse(Code::kLiteralEndsEarly, bytes_.empty() ? 0 : bytes_.size() - 1);
    return refuse(Code::kLiteralBracketOpen, open_.back(), {bytes_.substr(open_.back(), 1)});
  }

  void skip_blanks() {
    while (true) {
      at_ = std::min(bytes_.find_first_not_of(kBlanks, at_), bytes_.size());
      if (at_ == bytes_.size() || bytes_[at_] != '#') return;
      at_ = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
    }
  }

  [[nodiscard]] bool is_at(char c) const { return at_ < bytes_.size() && bytes_[at_] == c; }

  bool parse_value(Node& node) {
    skip_blanks();
    if (at_ == bytes_.size()) return refuse_end();
    const char c = bytes_[at_];
    if (c == '{' || c == '[' || c == '(') return parse_collection(node);
    if (begins_string(bytes_.substr(at_))) return parse_strings(node);
    return parse_word(node);
  }

  bool parse_word(Node& node) {
    const std::size_t start = at_;
    while (at_ < bytes_.size() && is_word_character(bytes_[at_])) ++at_;
    const std::string_view word = bytes_.substr(start, at_ - start);
    node.span = {start, word.size()};
    node.kind = word == "None" ? NodeKind::kNull : NodeKind::kScalar;
    if (word == "None") return true;
    if (word == "True" || word == "False") {
      node.value = word == "True" ? "true" : "false";
      return true;
    }
    node.value = word;
    return is_decimal(word) || refuse_word(word, start);
  }

  bool refuse_word(std::string_view word, std::size_t start) {
    constexpr std::size_t kLongest = 40;
    const std::string shown(word.substr(0, kLongest));
    if (word.empty()) return refuse(Code::kLiteralValueMissing, start);
    std::string letters;
    for (const char c : word) {
      if (c != '+' && c != '-') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (letters == "nan" || letters == "inf") return refuse(Code::kLiteralNotANumber, start);
    return refuse(can_begin_number(word[0]) ? Code::kLiteralNoNumber : Code::kLiteralNoValue, start, {shown});
  }

  /// One string and those that follow it with nothing but blanks and comments between.
  bool parse_strings(Node& node) {
    const std::size_t start = at_;
    std::size_t end = at_;
    node.kind = NodeKind::kScalar;
    node.quoted = true;
    for (bool first = true; at_ < bytes_.size() && begins_string(bytes_.substr(at_)); first = false) {
      PythonString string;
      if (const std::optional<Refusal> wrong = read_string(bytes_, at_, string)) {
        refusal_ = *wrong;
        return false;
      }
      if (!first && string.is_bytes == node.tag.empty()) return refuse(Code::kLiteralStringsMixed, at_);
      if (string.is_bytes) node.tag = kBytesTag;
      node.value += string.value;
      at_ = end = string.end;
      skip_blanks();
    }
    node.span = {start, end - start};
    return true;
  }

  bool parse_collection(Node& node) {
    if (open_.size() >= static_cast<std::size_t>(kMaxDepth)) {
      refusal_ = too_deep(at_);
      return false;
    }
    const std::size_t start = at_++;
    const char bracket = bytes_[start];
    open_.push_back(start);
    node.kind = bracket == '{' ? NodeKind::kMapping : NodeKind::kSequence;
    node.flow = true;
    const char closing = bracket == '{' ? '}' : bracket == '[' ? ']' : ')';
    bool has_comma = true;
    for (skip_blanks(); !is_at(closing); skip_blanks()) {
      if (at_ == bytes_.size()) return refuse_end();
      if (!has_comma) return refuse(Code::kLiteralCommaMissing, at_, {std::string(1, closing)});
      if (std::max(node.entries.size(), node.items.size()) == kLongestList) {
        refusal_ = too_long(at_);
        return false;
      }
      if (!(node.is_mapping() ? parse_entry(node.entries.emplace_back()) : parse_value(node.items.emplace_back())))
        return false;
      skip_blanks();
      has_comma = is_at(',');
      if (has_comma) ++at_;
    }
    open_.pop_back();
    node.span = {start, ++at_ - start};
    // Brackets around one value, not a tuple.
    const bool is_value = bracket == '(' && node.items.size() == 1 && !has_comma;
    if (is_value) node = Node(std::exchange(node.items.front(), {}));
    return true;
  }

  bool parse_entry(Entry& entry) {
    if (!begins_string(bytes_.substr(at_))) return refuse(Code::kLiteralKeyWanted, at_);
    if (!parse_strings(entry.key)) return false;
    skip_blanks();
    if (at_ == bytes_.size()) return refuse_end();
    if (!is_at(':')) return refuse(Code::kLiteralColonMissing, at_);
    ++at_;
    return parse_value(entry.value);
  }

  std::string_view bytes_;
  std::size_t at_;
  std::vector<std::size_t> open_;  ///< Offsets of the brackets that are still open.
  Refusal refusal_;
};

}  // namespace

std::optional<Node> parse_python(const Source& source, Diagnostics& diagnostics) {
  std::optional<Refusal> refusal = find_conflict_marker(source);
  if (const std::string valid = valid_utf8(source.bytes); !refusal && valid != source.bytes) {
    const auto wrong = std::ranges::mismatch(valid, source.bytes).in1;
    refusal = Refusal{{Code::kLiteralNotUtf8}, static_cast<std::size_t>(wrong - valid.begin())};
  }
  Node root;
  if (!refusal) {
    Parser parser(source);
    if (parser.parse(root)) return root;
    refusal = parser.refusal();
  }
  report(*refusal, source, diagnostics);
  return std::nullopt;
}

}  // namespace fca::text
