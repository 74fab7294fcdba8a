// SPDX-License-Identifier: BSD-3-Clause
#include "tab_fix.h"

#include <fca/code.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

namespace fca::checks {

namespace {

constexpr std::string_view kBlanks = " \t";

/// A line of block style that others may stand next to.
struct Level {
  std::size_t depth = 0;
  bool item = false;  ///< Begins with a dash.
};

class TabFixer {
 public:
  explicit TabFixer(const text::Source& source) : source_(source) {}

  std::optional<Fix> run() {
    for (std::size_t at = 0; at < source_.bytes.size();) {
      const std::size_t end = std::min(source_.bytes.find('\n', at), source_.bytes.size() - 1) + 1;
      if (!take_line(std::string_view(source_.bytes).substr(at, end - at))) return std::nullopt;
      at = end;
    }
    if (fixed_ == source_.bytes) return std::nullopt;
    // From the first byte that differs to the last.
    const auto [before, after] = std::ranges::mismatch(source_.bytes, fixed_);
    const auto begin = static_cast<std::size_t>(before - source_.bytes.begin());
    std::size_t same = 0;
    const std::size_t most = std::min(source_.bytes.size(), fixed_.size()) - begin;
    while (same < most && source_.bytes[source_.bytes.size() - 1 - same] == fixed_[fixed_.size() - 1 - same]) ++same;
    return Fix{{Code::kTabsToBlanks},
               {begin, source_.bytes.size() - same - begin},
               fixed_.substr(begin, fixed_.size() - same - begin)};
  }

 private:
  /// False: what is meant is not certain.
  bool take_line(std::string_view line) {
    const std::size_t first = std::min(line.find_first_not_of(kBlanks), line.size());
    const std::string_view indentation = line.substr(0, first);
    const std::string_view rest = line.substr(first);
    if (quote_ != '\0') {
      fixed_ += indentation;
    } else if (brackets_ > 0 || rest.empty() || rest.front() == '#' || rest.front() == '\n' || rest.front() == '\r') {
      // Any depth will do, if it is deeper than the list's key.
      fixed_ += indentation.find('\t') == std::string_view::npos ? std::string(indentation) : expanded(indentation);
    } else if (!take_indentation(indentation, rest)) {
      return false;
    }
    return take_rest(rest);
  }

  static std::string expanded(std::string_view indentation) {
    constexpr std::size_t kTabStop = 8;
    std::string text;
    for (const char c : indentation) text.append(c == '\t' ? kTabStop - text.size() % kTabStop : 1, ' ');
    return text;
  }

  bool take_indentation(std::string_view indentation, std::string_view rest) {
    const bool item = rest.starts_with("- ") || rest.starts_with("-\t");
    std::optional<std::size_t> depth = indentation.size();
    if (indentation.find('\t') != std::string_view::npos) depth = depth_of(indentation, item);
    if (!depth) return false;
    std::erase_if(levels_, [&depth](const Level& level) { return level.depth > *depth; });
    if (std::ranges::none_of(levels_, [&](const Level& level) { return level.depth == *depth && level.item == item; }))
      levels_.push_back({*depth, item});
    known_[std::string(indentation)] = *depth;
    fixed_.append(*depth, ' ');
    depth_ = *depth;
    return true;
  }

  std::optional<std::size_t> depth_of(std::string_view indentation, bool item) {
    constexpr std::size_t kStep = 2;
    if (opened_) return depth_ + kStep;  // a key without a value: what follows is inside it
    const auto fits = [item](const Level& level) { return level.item == item && level.depth > 0; };
    const auto known = known_.find(std::string(indentation));
    if (known != known_.end() &&
        std::ranges::any_of(levels_, [&](const Level& level) { return fits(level) && level.depth == known->second; })) {
      return known->second;
    }
    if (std::ranges::count_if(levels_, fits) != 1) return std::nullopt;
    return std::ranges::find_if(levels_, fits)->depth;
  }

  /// After the indentation: a TAB between two words is a blank, one within a word without quotes is its part.
  bool take_rest(std::string_view rest) {
    char last = '\0';      // that is no blank
    std::size_t word = 0;  // where the last word begins
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const char c = rest[i];
      if (quote_ == '\0' && c == '#' && (i == 0 || kBlanks.find(rest[i - 1]) != std::string_view::npos)) {
        fixed_ += rest.substr(i);
        break;
      }
      if (quote_ == '\0' && c == '\t' && !between_words(rest, i, last)) return false;
      fixed_ += quote_ == '\0' && c == '\t' ? ' ' : c;
      follow(c, last);
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
      if (i > 0 && kBlanks.find(rest[i - 1]) != std::string_view::npos) word = i;
      last = c;
    }
    // A key without a value, or with a tag alone (!!opencv-matrix).
    if (last != '\0' && quote_ == '\0') opened_ = brackets_ == 0 && (last == ':' || (word > 0 && rest[word] == '!'));
    return true;
  }

  static bool between_words(std::string_view rest, std::size_t tab, char last) {
    const std::size_t next = rest.find_first_not_of(kBlanks, tab);
    constexpr std::string_view kBefore = ":,[{-?]}\"'";
    constexpr std::string_view kBehind = "#,]}\r\n";
    return next == std::string_view::npos || last == '\0' || kBefore.find(last) != std::string_view::npos ||
           kBehind.find(rest[next]) != std::string_view::npos;
  }

  void follow(char c, char last) {
    if (quote_ != '\0') {
      if (c == quote_) quote_ = '\0';
      return;
    }
    // A quote within a word is none.
    const bool begins = last == '\0' || std::string_view(":,[{-").find(last) != std::string_view::npos;
    if ((c == '"' || c == '\'') && begins) quote_ = c;
    if (c == '[' || c == '{') ++brackets_;
    if ((c == ']' || c == '}') && brackets_ > 0) --brackets_;
  }

  const text::Source& source_;
  std::string fixed_;
  std::vector<Level> levels_;
  std::map<std::string, std::size_t> known_;  ///< What an indentation was before.
  std::size_t depth_ = 0;
  std::size_t brackets_ = 0;
  char quote_ = '\0';
  bool opened_ = false;  ///< The last line ended with a key's colon.
};

}  // namespace

std::optional<Fix> tab_fix(const text::Source& source) { return TabFixer(source).run(); }

}  // namespace fca::checks
