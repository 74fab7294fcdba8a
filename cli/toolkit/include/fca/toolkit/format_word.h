// SPDX-License-Identifier: BSD-3-Clause
// What a format calls its modes ("stereo-inertial") and its layouts ("v1"). A request cannot hold any other word.
#pragma once

#include <fca/formats/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace fca {

/// One of the words in a list of its format.
template <std::span<const std::string_view> Format::*kWords>
class FormatWord {
 public:
  /// Nothing of a word that the format does not have.
  [[nodiscard]] static std::optional<FormatWord> find(const Format& format, std::string_view word) {
    const auto found = std::ranges::find(format.*kWords, word);
    return found == (format.*kWords).end() ? std::nullopt : std::optional(FormatWord(format, *found));
  }

  [[nodiscard]] const Format& format() const { return *format_; }
  [[nodiscard]] std::string_view name() const { return name_; }

 private:
  FormatWord(const Format& format, std::string_view name) : format_(&format), name_(name) {}

  const Format* format_;
  std::string_view name_;
};

using FormatMode = FormatWord<&Format::modes>;
using FormatLayout = FormatWord<&Format::layouts>;

/// Its name; empty: there is none.
template <class Word>
[[nodiscard]] std::string_view name_of(const std::optional<Word>& word) {
  return word ? word->name() : std::string_view();
}

}  // namespace fca
