// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/dialect.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace fca::text {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_digit(text[at]) || text[at] == '_')) ++at;
  return at;
}

/// After "12." or ".5": nothing, or an exponent with its sign.
bool ends_as_real(std::string_view rest) {
  if (rest.empty()) return true;
  if (rest.size() < 3 || (rest[0] != 'e' && rest[0] != 'E') || (rest[1] != '+' && rest[1] != '-')) return false;
  return std::ranges::all_of(rest.substr(2), is_digit);
}

/// Decimal part of PyYAML's YAML 1.1 resolver: an integer is digits; a real needs a point, an exponent its sign, and what
/// begins with the point takes no sign.
ScalarType pyyaml_type(std::string_view text) {
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::string_view rest = text.substr(sign);
  if (rest == ".inf" || rest == ".Inf" || rest == ".INF") return ScalarType::kReal;
  if (text == ".nan" || text == ".NaN" || text == ".NAN") return ScalarType::kReal;
  if (sign == 0 && text.size() > 1 && text[0] == '.' && is_digit(text[1])) {
    return ends_as_real(text.substr(skip_digits(text, 1))) ? ScalarType::kReal : ScalarType::kText;
  }
  if (rest.empty() || !is_digit(rest[0])) return ScalarType::kText;
  const std::size_t whole_end = skip_digits(text, sign);
  if (whole_end == text.size()) return ScalarType::kInteger;
  if (text[whole_end] != '.') return ScalarType::kText;
  return ends_as_real(text.substr(skip_digits(text, whole_end + 1))) ? ScalarType::kReal : ScalarType::kText;
}

/// cv::FileStorage 4.6, persistence_yml.cpp: after sign and leading digits, '.' or 'e' makes it a real, anything else strtol's
/// int.
ScalarType opencv_type(std::string_view text) {
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  if (sign >= text.size()) return ScalarType::kText;
  const bool number = is_digit(text[sign]) || (text[sign] == '.' && sign + 1 < text.size());
  if (!number) return ScalarType::kText;
  std::size_t at = sign;
  while (at < text.size() && is_digit(text[at])) ++at;
  return at < text.size() && (text[at] == '.' || text[at] == 'e') ? ScalarType::kReal : ScalarType::kInteger;
}

}  // namespace

ScalarType scalar_type(const Node& scalar, Dialect dialect) {
  if (!scalar.is_scalar() || scalar.quoted || scalar.value.empty()) return ScalarType::kText;
  return dialect == Dialect::kPyYaml ? pyyaml_type(scalar.value) : opencv_type(scalar.value);
}

const Entry* find_entry(const Node& mapping, std::string_view key, Dialect dialect) {
  const auto matches = [key](const Entry& entry) { return entry.key.is_scalar() && entry.key.value == key; };
  if (dialect == Dialect::kPyYaml) {
    const auto last = std::find_if(mapping.entries.rbegin(), mapping.entries.rend(), matches);
    return last == mapping.entries.rend() ? nullptr : &*last;
  }
  const auto first = std::ranges::find_if(mapping.entries, matches);
  return first == mapping.entries.end() ? nullptr : &*first;
}

std::vector<const Entry*> shadowed_entries(const Node& mapping, Dialect dialect) {
  std::unordered_map<std::string_view, const Entry*> counting;
  std::vector<const Entry*> shadowed;
  for (const Entry& entry : mapping.entries) {
    const auto [place, fresh] = counting.emplace(entry.key.value, &entry);
    if (fresh) continue;
    const bool last_counts = dialect == Dialect::kPyYaml;
    shadowed.push_back(last_counts ? std::exchange(place->second, &entry) : &entry);
  }
  std::ranges::sort(shadowed);  // entries stand in file order
  return shadowed;
}

const Node* find(const Node& mapping, std::string_view key, Dialect dialect) {
  const Entry* entry = find_entry(mapping, key, dialect);
  return entry == nullptr ? nullptr : &entry->value;
}

}  // namespace fca::text
