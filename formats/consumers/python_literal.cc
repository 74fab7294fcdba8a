// SPDX-License-Identifier: BSD-3-Clause
// A tokenizer, then a tree of its tokens, as Python itself goes about it.
#include "python_literal.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <limits>

namespace fca::consumers::python {

namespace {

enum class TokenKind { kPunctuation, kNumber, kName, kString, kEnd };

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string_view text;  ///< Of strings what stands between the quotes.
  std::size_t line = 1;
  bool raw = false;  ///< Strings: r'..'
  bool bytes = false;
};

/// Why Python raises.
struct Raised {
  const char* what;
  std::size_t line;
};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || (c & 0x80) != 0; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr const char* kSyntaxError = "SyntaxError";
constexpr const char* kIndentationError = "IndentationError";
constexpr const char* kValueError = "ValueError";

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    // literal_eval strips blanks and tabs, and no line, from the left.
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    while (true) {
      skip_blanks();
      if (at_ == text_.size()) break;
      next();
    }
    tokens_.push_back({.kind = TokenKind::kEnd, .text = {}, .line = line_});
    return std::move(tokens_);
  }

 private:
  [[noreturn]] void raise(const char* what) const { throw Raised{what, line_}; }

  void skip_blanks() {
    bool at_line_begin = line_ > 1 && depth_ == 0 && tokens_.empty();
    bool blanks = false;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '#') {
        while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n' && text_[at_ + 1] != '\r') ++at_;
      } else if (c == '\n' || c == '\r') {
        if (c == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
        ++line_;
        at_line_begin = depth_ == 0;
        blanks = false;
      } else if (c == ' ' || c == '\t') {
        blanks = true;
      } else if (c != '\f') {
        break;
      }
    }
    // Outside of brackets the depth of a line means something.
    if (at_line_begin && blanks && (at_ < text_.size() || text_.back() == ' ' || text_.back() == '\t'))
      raise(kIndentationError);
    // One expression, on one line but for its brackets.
    if (at_line_begin && !tokens_.empty() && at_ < text_.size()) raise(kSyntaxError);
  }

  void next() {
    const char c = text_[at_];
    if (quote_at() != std::string_view::npos) return string();
    if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) return number();
    if (is_letter(c)) return name();
    if (c == '{' || c == '[' || c == '(') ++depth_;
    if ((c == '}' || c == ']' || c == ')') && depth_-- == 0) raise(kSyntaxError);
    if (std::string_view("{}[](),:+-").find(c) == std::string_view::npos) raise(kSyntaxError);
    tokens_.push_back({.kind = TokenKind::kPunctuation, .text = text_.substr(at_++, 1), .line = line_});
  }

  /// Where the quote of a string that begins here stands.
  [[nodiscard]] std::size_t quote_at() const {
    std::size_t at = at_;
    while (at < text_.size() && at - at_ < 2 && std::string_view("bBrRuU").find(text_[at]) != std::string_view::npos) ++at;
    return at < text_.size() && (text_[at] == '\'' || text_[at] == '"') ? at : std::string_view::npos;
  }

  void string() {
    const std::size_t quote = quote_at();
    Token token = {.kind = TokenKind::kString, .text = {}, .line = line_};
    for (const char c : text_.substr(at_, quote - at_)) {
      const bool again = (token.raw && (c == 'r' || c == 'R')) || (token.bytes && (c == 'b' || c == 'B'));
      if (again || (quote - at_ == 2 && (c == 'u' || c == 'U'))) raise(kSyntaxError);
      token.raw = token.raw || c == 'r' || c == 'R';
      token.bytes = token.bytes || c == 'b' || c == 'B';
    }
    const char mark = text_[quote];
    const bool is_long = text_.substr(quote, 3) == std::string(3, mark);
    const std::string_view end = text_.substr(quote, is_long ? 3 : 1);
    std::size_t at = quote + end.size();
    const std::size_t begin = at;
    while (text_.substr(at, end.size()) != end) {
      if (at >= text_.size()) raise(kSyntaxError);
      if (!is_long && (text_[at] == '\n' || text_[at] == '\r')) raise(kSyntaxError);
      if (token.bytes && (text_[at] & 0x80) != 0) raise(kSyntaxError);
      if (text_[at] == '\n') ++line_;
      at += text_[at] == '\\' ? 2 : 1;
    }
    token.text = text_.substr(begin, at - begin);
    at_ = at + end.size();
    tokens_.push_back(token);
  }

  void number() {
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      const char before = at_ > begin ? text_[at_ - 1] : '0';
      const bool is_exponent = (before == 'e' || before == 'E') && (c == '+' || c == '-');
      if (!is_digit(c) && !is_letter(c) && c != '.' && !is_exponent) break;
      ++at_;
    }
    tokens_.push_back({.kind = TokenKind::kNumber, .text = text_.substr(begin, at_ - begin), .line = line_});
  }

  void name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    tokens_.push_back({.kind = TokenKind::kName, .text = text_.substr(begin, at_ - begin), .line = line_});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t depth_ = 0;  ///< Of brackets.
  std::vector<Token> tokens_;
};

void append_utf8(std::uint32_t code, std::string& text) {
  constexpr std::uint32_t kFirst[] = {0x00, 0xC0, 0xE0, 0xF0};
  const int following = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  text += static_cast<char>(kFirst[following] | (code >> (6 * following)));
  for (int i = following - 1; i >= 0; --i) text += static_cast<char>(0x80 | ((code >> (6 * i)) & 0x3F));
}

std::string resolved(const Token& token) {
  if (token.raw || token.bytes) return std::string(token.text);
  std::string text;
  const std::string_view from = token.text;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] != '\\' || i + 1 == from.size()) {
      text += from[i];
      continue;
    }
    const char c = from[++i];
    const std::size_t hex = c == 'x' ? 2 : c == 'u' ? 4 : c == 'U' ? 8 : 0;
    std::uint32_t code = 0;
    if (hex > 0) {
      const char* const begin = from.data() + i + 1;
      const char* const end = from.data() + std::min(from.size(), i + 1 + hex);
      if (std::from_chars(begin, end, code, 16).ptr != begin + hex || code > 0x10FFFF) throw Raised{kSyntaxError, token.line};
      append_utf8(code, text);
      i += hex;
    } else if (c >= '0' && c <= '7') {
      const char* const begin = from.data() + i;
      const char* const end = std::from_chars(begin, from.data() + std::min(from.size(), i + 3), code, 8).ptr;
      append_utf8(code, text);
      i += static_cast<std::size_t>(end - begin) - 1;
    } else if (c == '\n') {
      continue;
    } else if (const std::size_t known = std::string_view("abfnrtv\\'\"").find(c); known != std::string_view::npos) {
      text += "\a\b\f\n\r\t\v\\'\""[known];
    } else {
      text += '\\';
      text += c;
    }
  }
  return text;
}

/// The underscores between digits taken out; raises where one stands elsewhere.
std::string without_underscores(const Token& token) {
  std::string digits;
  for (std::size_t i = 0; i < token.text.size(); ++i) {
    if (token.text[i] != '_') {
      digits += token.text[i];
      continue;
    }
    const bool between = i > 0 && i + 1 < token.text.size() &&
                         std::isalnum(static_cast<unsigned char>(token.text[i - 1])) != 0 &&
                         std::isalnum(static_cast<unsigned char>(token.text[i + 1])) != 0;
    if (!between) throw Raised{kSyntaxError, token.line};
  }
  return digits;
}

Value number_of(const Token& token) {
  const std::string digits = without_underscores(token);
  const char* const end = digits.data() + digits.size();
  Value value;
  const char second = digits.size() > 1 ? digits[1] : '0';
  const int base = second == 'x' || second == 'X'   ? 16
                   : second == 'o' || second == 'O' ? 8
                   : second == 'b' || second == 'B' ? 2
                                                    : 10;
  if (base != 10 && digits[0] == '0') {
    std::uint64_t whole = 0;
    const auto [stop, error] = std::from_chars(digits.data() + 2, end, whole, base);
    if (stop != end || digits.size() < 3) throw Raised{kSyntaxError, token.line};
    value.kind = Kind::kInt;
    value.number = static_cast<double>(whole);
    return value;
  }
  const auto [stop, error] = std::from_chars(digits.data(), end, value.number);
  if (stop != end) throw Raised{kSyntaxError, token.line};  // complex numbers, too: nothing here is one
  if (error == std::errc::result_out_of_range) {
    const bool is_tiny = digits.find("e-") != std::string::npos || digits.find("E-") != std::string::npos;
    value.number = is_tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  value.kind = digits.find_first_of(".eE") == std::string::npos ? Kind::kInt : Kind::kFloat;
  const bool zeros = digits.find_first_not_of('0') == std::string::npos;
  if (value.kind == Kind::kInt && digits.size() > 1 && digits[0] == '0' && !zeros) throw Raised{kSyntaxError, token.line};
  return value;
}

/// CPython's own parser stops at some depth, too.
constexpr std::size_t kDeepest = 90;

class Reader {
 public:
  explicit Reader(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  Value run() {
    Value root = value();
    // A comma after it makes it a tuple.
    if (here().kind != TokenKind::kEnd) raise(kSyntaxError);
    return root;
  }

 private:
  [[noreturn]] void raise(const char* what) const { throw Raised{what, here().line}; }
  [[nodiscard]] const Token& here() const { return tokens_[at_]; }
  [[nodiscard]] bool is(char c) const { return here().kind == TokenKind::kPunctuation && here().text[0] == c; }
  bool take(char c) {
    if (!is(c)) return false;
    ++at_;
    return true;
  }
  void want(char c) {
    if (!take(c)) raise(kSyntaxError);
  }

  Value value() {
    if (++depth_ > kDeepest) raise("MemoryError");
    Value result = is('{') ? dict() : is('[') ? list(']') : is('(') ? list(')') : atom();
    --depth_;
    return result;
  }

  Value atom() {
    switch (here().kind) {
      case TokenKind::kString:
        return strings();
      case TokenKind::kNumber:
        return number_of(tokens_[at_++]);
      case TokenKind::kName:
        return name();
      case TokenKind::kPunctuation:
        if (is('+') || is('-')) return signed_number();
        break;
      case TokenKind::kEnd:
        break;
    }
    raise(kSyntaxError);
  }

  Value signed_number() {
    const bool negative = is('-');
    ++at_;
    if (here().kind != TokenKind::kNumber) raise(kValueError);
    Value value = number_of(tokens_[at_++]);
    if (negative) value.number = -value.number;
    // The int -0 is 0.
    if (value.kind == Kind::kInt && value.number == 0.0) value.number = 0.0;
    return value;
  }

  Value name() {
    const std::string_view word = here().text;
    Value value;
    if (word == "True" || word == "False") {
      value.kind = Kind::kBool;
      value.number = word == "True" ? 1.0 : 0.0;
    } else if (word != "None") {
      raise(kValueError);
    }
    ++at_;
    return value;
  }

  Value strings() {
    Value value;
    value.kind = here().bytes ? Kind::kBytes : Kind::kString;
    while (here().kind == TokenKind::kString) {
      if (here().bytes != (value.kind == Kind::kBytes)) raise(kSyntaxError);
      value.text += resolved(tokens_[at_++]);
    }
    return value;
  }

  Value list(char closing) {
    ++at_;
    Value list;
    list.kind = Kind::kList;
    bool comma = true;
    while (!is(closing)) {
      if (!comma) raise(kSyntaxError);
      list.items.push_back(value());
      comma = take(',');
    }
    ++at_;
    if (closing == ')' && list.items.size() == 1 && !comma) {
      Value inner = std::move(list.items.front());
      return inner;
    }
    return list;
  }

  Value dict() {
    ++at_;
    Value dict;
    dict.kind = Kind::kDict;
    bool comma = true;
    while (!is('}')) {
      if (!comma) raise(kSyntaxError);
      const Value key = value();
      want(':');
      Value of_key = value();
      comma = take(',');
      if (key.kind == Kind::kList || key.kind == Kind::kDict) raise("TypeError");
      if (key.kind != Kind::kString) continue;  // mrcal asks for none
      dict.entries.push_back({key.text, std::move(of_key)});
    }
    ++at_;
    return dict;
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
};

}  // namespace

const Value* Value::find(std::string_view key) const {
  const auto found = std::find_if(entries.rbegin(), entries.rend(), [key](const Entry& entry) { return entry.key == key; });
  return found == entries.rend() ? nullptr : &found->value;
}

Loaded literal_eval(std::string_view text) {
  Loaded loaded;
  try {
    if (text.starts_with("\xEF\xBB\xBF")) throw Raised{kSyntaxError, 1};
    loaded.root = Reader(Tokenizer(text).run()).run();
  } catch (const Raised& raised) {
    loaded.error = std::string(raised.what) + " in line " + std::to_string(raised.line);
  }
  return loaded;
}

}  // namespace fca::consumers::python
