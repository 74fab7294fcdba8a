// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace fca::text {

namespace {

/// from_chars takes no '+', but every format writes one now and then. "+-1" stays wrong.
std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  return text;
}

std::optional<double> parse_special(std::string_view text) {
  const bool negative = text.starts_with('-');
  const std::string_view name = negative ? text.substr(1) : text;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (name == ".inf" || name == ".Inf" || name == ".INF") return negative ? -kInfinity : kInfinity;
  if (name == ".nan" || name == ".NaN" || name == ".NAN" || name == ".Nan") return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}

/// Is a literal that from_chars cannot represent too large (or too small)? Decided by the place of its first non-zero digit.
bool beyond_largest(std::string_view literal) {
  const std::size_t exponent_at = std::min(literal.find_first_of("eE"), literal.size());
  const std::string_view mantissa = literal.substr(0, exponent_at);
  constexpr long kMostDigits = 1'000'000'000;
  long exponent = 0;
  if (exponent_at < literal.size()) {
    const std::string_view digits = without_plus(literal.substr(exponent_at + 1));
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error == std::errc::result_out_of_range) exponent = digits.starts_with('-') ? -kMostDigits : kMostDigits;
  }
  const auto point = static_cast<long>(std::min(mantissa.find('.'), mantissa.size()));
  const auto first = static_cast<long>(std::min(mantissa.find_first_of("123456789"), mantissa.size()));
  return exponent + (point - first) > 0;
}

}  // namespace

std::optional<double> parse_real(std::string_view text) {
  text = without_plus(text);
  if (const std::optional<double> special = parse_special(text)) return special;
  // from_chars takes "nan" and "infinity" in letters; no file format does.
  if (text.find_first_not_of("+-.0123456789eE") != std::string_view::npos) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too small is zero to every consumer; too large is infinite to them, and that is what the caller must see.
    const double limit = beyond_largest(text) ? std::numeric_limits<double>::infinity() : 0.0;
    return text.starts_with('-') ? -limit : limit;
  }
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::optional<int> parse_int(std::string_view text) {
  text = without_plus(text);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string format_real(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0.0 ? ".inf" : "-.inf";
  std::array<char, 40> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), result.ptr);
  const std::size_t exponent = text.find('e');
  const std::size_t mantissa_end = exponent == std::string::npos ? text.size() : exponent;
  if (text.find('.') == std::string::npos) text.insert(mantissa_end, ".0");
  return text;  // to_chars writes the exponent's sign always
}

std::string format_short(double value, int digits) {
  std::array<char, 40> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
  return {buffer.data(), result.ptr};
}

std::optional<std::vector<double>> reals_in(std::string_view list) {
  constexpr std::string_view kDigits = "+-.0123456789eE";
  std::vector<double> numbers;
  for (std::size_t at = list.find_first_of(kDigits); at != std::string_view::npos; at = list.find_first_of(kDigits, at)) {
    const std::size_t end = std::min(list.find_first_not_of(kDigits, at), list.size());
    const std::optional<double> number = parse_real(list.substr(at, end - at));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    at = end;
  }
  return numbers;
}

}  // namespace fca::text
