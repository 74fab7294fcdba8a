// SPDX-License-Identifier: BSD-3-Clause
#include "python_string.h"

#include "utf8.h"

#include <fca/code.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace fca::text {

namespace {

bool is_quote(char c) { return c == '\'' || c == '"'; }

/// The length of the prefix before a string's first quote; nothing where no string begins.
std::optional<std::size_t> prefix_of(std::string_view text) {
  constexpr std::size_t kLongest = 2;
  constexpr std::string_view kPrefixes[] = {"", "b", "r", "u", "br", "rb"};
  std::string prefix;
  for (std::size_t i = 0; i < std::min(kLongest + 1, text.size()); ++i) {
    if (is_quote(text[i])) return std::ranges::find(kPrefixes, prefix) != std::end(kPrefixes) ? std::optional(i) : std::nullopt;
    prefix += static_cast<char>(text[i] >= 'A' && text[i] <= 'Z' ? text[i] - 'A' + 'a' : text[i]);
  }
  return std::nullopt;
}

/// What stands after a backslash: appends what it means and returns its length; 0 where it means nothing.
std::size_t append_escape(std::string_view text, std::string& value) {
  constexpr std::string_view kLetters = "\\'\"abfnrtv";
  constexpr std::string_view kMeant = "\\'\"\a\b\f\n\r\t\v";
  const char c = text[0];
  if (const std::size_t letter = kLetters.find(c); letter != std::string_view::npos) {
    value += kMeant[letter];
    return 1;
  }
  if (c == '\n') return 1;  // the line goes on
  if (c == '\r') return text.substr(1).starts_with('\n') ? 2 : 1;
  constexpr std::size_t kOctalDigits = 3;
  std::uint32_t code = 0;
  if (c >= '0' && c <= '7') {
    const std::string_view digits = text.substr(0, kOctalDigits);
    const char* const end = std::from_chars(digits.data(), digits.data() + digits.size(), code, 8).ptr;
    append_utf8(code, value);
    return static_cast<std::size_t>(end - digits.data());
  }
  const std::size_t count = c == 'x' ? 2 : c == 'u' ? 4 : c == 'U' ? 8 : 0;
  if (count == 0 && c == 'N') return 0;
  if (count == 0) {  // a backslash as any other character
    value += '\\';
    value += c;
    return 1;
  }
  const std::string_view digits = text.substr(1, count);
  const char* const end = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16).ptr;
  const bool is_whole = digits.size() == count && end == digits.data() + count;
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (!is_whole || is_surrogate || code > 0x10FFFF) return 0;
  append_utf8(code, value);
  return 1 + count;
}

}  // namespace

bool begins_string(std::string_view text) { return prefix_of(text).has_value(); }

std::optional<Refusal> read_string(std::string_view bytes, std::size_t start, PythonString& string) {
  const std::size_t quote = start + prefix_of(bytes.substr(start)).value_or(0);
  const std::string_view prefix = bytes.substr(start, quote - start);
  string.is_bytes = prefix.find_first_of("bB") != std::string_view::npos;
  const bool keeps_escapes = string.is_bytes || prefix.find_first_of("rR") != std::string_view::npos;
  constexpr std::size_t kLong = 3;
  const std::string three(kLong, bytes[quote]);
  const std::string closing = bytes.substr(quote).starts_with(three) ? three : std::string(1, bytes[quote]);
  for (std::size_t at = quote + closing.size(); at < bytes.size();) {
    if (bytes.substr(at).starts_with(closing)) {
      string.end = at + closing.size();
      return std::nullopt;
    }
    const char c = bytes[at];
    if (closing.size() == 1 && (c == '\n' || c == '\r')) return Refusal{{Code::kLiteralStringOfLines}, start};
    if (c != '\\') {
      string.value += c;
      ++at;
    } else if (at + 1 == bytes.size()) {
      break;
    } else if (keeps_escapes) {
      string.value += bytes.substr(at, 2);
      at += 2;
    } else {
      const std::size_t length = append_escape(bytes.substr(at + 1), string.value);
      if (length == 0) return Refusal{{Code::kLiteralWrongEscape}, at};
      at += 1 + length;
    }
  }
  return Refusal{{Code::kLiteralStringOpen}, start};
}

}  // namespace fca::text
