// SPDX-License-Identifier: BSD-3-Clause
#include "pyyaml_scalars.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

namespace fca::consumers::pyyaml {

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t skip(std::string_view& text, std::string_view set) {
  const std::size_t count = std::min(text.find_first_not_of(set), text.size());
  text.remove_prefix(count);
  return count;
}

namespace {

bool skip_one(std::string_view& text, std::string_view set) {
  if (text.empty() || set.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kDigitsOrUnderscore = "0123456789_";

/// (?::[0-5]?[0-9])+ : the further places of a base-60 number.
bool skip_sexagesimal_places(std::string_view& text) {
  std::size_t places = 0;
  while (!text.empty() && text.front() == ':') {
    std::string_view rest = text.substr(1);
    const std::size_t digits = std::min(rest.find_first_not_of(kDigits), rest.size());
    if (digits == 0 || digits > 2 || (digits == 2 && rest.front() > '5')) return false;
    text.remove_prefix(digits + 1);
    ++places;
  }
  return places > 0;
}

/// An empty rest, or an exponent, which must have a sign: 1.0e5 is a string in PyYAML.
bool is_optional_exponent(std::string_view text) {
  if (text.empty()) return true;
  return skip_one(text, "eE") && skip_one(text, "+-") && skip(text, kDigits) > 0 && text.empty();
}

double parse_digits(std::string_view digits, int base) {
  double value = 0.0;
  for (const char c : digits) {
    const int digit = is_digit(c) ? c - '0' : (c | 0x20) - 'a' + 10;
    value = value * base + digit;
  }
  return value;
}

double parse_decimal(std::string_view text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc::result_out_of_range) return value;
  return text.find("e-") != std::string_view::npos ? 0.0 : std::numeric_limits<double>::infinity();
}

double parse_sexagesimal(std::string_view text) {
  double value = 0.0;
  while (!text.empty()) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    value = value * 60.0 + parse_decimal(text.substr(0, colon));
    text.remove_prefix(std::min(colon + 1, text.size()));
  }
  return value;
}

}  // namespace

bool matches_float(std::string_view text) {
  std::string_view rest = text;
  if (rest.starts_with('.') && rest.size() > 1 && is_digit(rest[1])) {  // no sign here: -.5 is a string
    rest.remove_prefix(1);
    skip(rest, kDigitsOrUnderscore);
    return is_optional_exponent(rest);
  }
  if (is_one_of(text, {".nan", ".NaN", ".NAN"})) return true;
  skip_one(rest, "+-");
  if (is_one_of(rest, {".inf", ".Inf", ".INF"})) return true;
  if (rest.empty() || !is_digit(rest.front())) return false;
  skip(rest, kDigitsOrUnderscore);
  const bool sexagesimal = skip_sexagesimal_places(rest);
  if (!skip_one(rest, ".")) return false;
  skip(rest, kDigitsOrUnderscore);
  return sexagesimal ? rest.empty() : is_optional_exponent(rest);
}

bool matches_int(std::string_view text) {
  skip_one(text, "+-");
  if (text.empty() || !is_digit(text.front())) return false;
  const auto only = [](std::string_view rest, std::string_view set) { return skip(rest, set) > 0 && rest.empty(); };
  if (text == "0") return true;
  if (text.starts_with("0b")) return only(text.substr(2), "01_");
  if (text.starts_with("0x")) return only(text.substr(2), "0123456789abcdefABCDEF_");
  if (text.front() == '0') return only(text.substr(1), "01234567_");
  skip(text, kDigitsOrUnderscore);
  return text.empty() || (skip_sexagesimal_places(text) && text.empty());
}

double parse_number(std::string_view text, Kind kind) {
  std::string plain;
  for (const char c : text) {
    if (c != '_') plain += static_cast<char>((c >= 'A' && c <= 'Z') ? c + 0x20 : c);
  }
  std::string_view rest = plain;
  const double sign = rest.starts_with('-') ? -1.0 : 1.0;
  skip_one(rest, "+-");
  if (rest == ".inf") return sign * std::numeric_limits<double>::infinity();
  if (rest == ".nan") return std::numeric_limits<double>::quiet_NaN();
  if (rest.find(':') != std::string_view::npos) return sign * parse_sexagesimal(rest);
  if (kind == Kind::kInt && rest.starts_with("0b")) return sign * parse_digits(rest.substr(2), 2);
  if (kind == Kind::kInt && rest.starts_with("0x")) return sign * parse_digits(rest.substr(2), 16);
  if (kind == Kind::kInt && rest.starts_with('0')) return sign * parse_digits(rest, 8);
  return sign * parse_decimal(rest);
}

Value resolve_plain_scalar(std::string_view text) {
  Value value;
  value.text = std::string(text);
  if (is_one_of(text, {"", "~", "null", "Null", "NULL"})) {
    value.kind = Kind::kNull;
  } else if (is_one_of(text, {"yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"})) {
    value.kind = Kind::kBool;
    value.number = 1.0;
  } else if (is_one_of(text, {"no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"})) {
    value.kind = Kind::kBool;
  } else if (matches_float(text)) {
    value.kind = Kind::kFloat;
  } else if (matches_int(text)) {
    value.kind = Kind::kInt;
  } else {
    value.kind = Kind::kString;
  }
  if (value.kind == Kind::kFloat || value.kind == Kind::kInt) value.number = parse_number(text, value.kind);
  return value;
}

}  // namespace fca::consumers::pyyaml
