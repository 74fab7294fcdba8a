// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/prose.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace fca::text {

std::string enumerated(std::span<const std::string> parts, std::string_view last_word) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " " + std::string(last_word) + " " : ", ";
    text += parts[i];
  }
  return text;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t kMost = 100;
  if (text.size() <= kMost) return std::string(text);
  std::size_t end = kMost;
  const auto continues = [&text](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };  // UTF-8
  while (end > 0 && continues(end)) --end;
  return std::string(text.substr(0, end)) + " ...";
}

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

/// Is `word` what `of` begins with ("orb" of "orbslam3")? A short word begins much.
bool is_beginning(std::string_view word, std::string_view of) {
  constexpr std::size_t kShortest = 3;
  return word.size() >= kShortest && of.starts_with(word);
}

/// How many letters of `typed` are wrong; nothing if it is so far from `name` that it means something else.
std::optional<std::size_t> wrong_letters(std::string_view typed, std::string_view name) {
  constexpr std::size_t kShort = 3;
  constexpr std::size_t kOneIn = 3;
  if (is_beginning(typed, name) || (name.size() > kShort && is_beginning(name, typed))) return 1;
  if (typed.empty() || name.empty()) return std::nullopt;
  if (is_misspelling(typed, name)) return 1;
  const std::size_t wrong = edit_distance(typed.substr(0, 64), name);
  const bool is_short = std::min(typed.size(), name.size()) <= kShort;
  const bool is_near =
      is_short ? wrong <= 1 && typed.front() == name.front() : wrong * kOneIn <= std::max(typed.size(), name.size());
  return is_near ? std::optional(wrong) : std::nullopt;
}

}  // namespace

std::vector<std::string> nearest(std::string_view typed, std::span<const std::string> names) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& name : names) {
    if (const std::optional<std::size_t> wrong = wrong_letters(typed, name)) ranked.emplace_back(*wrong, name);
  }
  std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, std::string>::first);
  std::vector<std::string> result;
  for (const auto& [wrong, name] : ranked) {
    if (result.size() < 3) result.push_back(name);
  }
  return result;
}

bool is_misspelling(std::string_view typed, std::string_view meant) {
  constexpr std::size_t kShortest = 4;
  if (typed == meant || meant.size() < kShortest || typed.size() + 1 < meant.size() || typed.size() > meant.size() + 1)
    return false;
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (std::ranges::equal(typed, meant, {}, lower, lower)) return true;
  const std::size_t shorter = std::min(typed.size(), meant.size());
  std::size_t front = 0;
  while (front < shorter && typed[front] == meant[front]) ++front;
  std::size_t back = 0;
  while (back < shorter - front && typed[typed.size() - 1 - back] == meant[meant.size() - 1 - back]) ++back;
  const std::string_view wrong = typed.substr(front, typed.size() - front - back);
  const std::string_view right = meant.substr(front, meant.size() - front - back);
  const auto has_digit = [](std::string_view word) { return word.find_first_of("0123456789") != std::string_view::npos; };
  if (has_digit(wrong) || has_digit(right)) return false;
  if (wrong.size() <= 1 && right.size() <= 1) return true;
  return wrong.size() == 2 && right.size() == 2 && wrong[0] == right[1] && wrong[1] == right[0];
}

std::string shell_word(std::string_view word) {
  constexpr std::string_view kSafe = "_-./=,:+@%{}";
  const bool plain = !word.empty() && std::ranges::all_of(word, [kSafe](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           kSafe.find(c) != std::string_view::npos;
  });
  if (plain) return std::string(word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace fca::text
