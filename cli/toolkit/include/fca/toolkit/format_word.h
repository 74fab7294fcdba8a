// SPDX-License-Identifier: BSD-3-Clause
// The names of a format's modes ("stereo-inertial") and layouts ("v1"). A FormatWord can only hold a name that its format has.
#pragma once

#include <fca/formats/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace fca {

/// A word from one of the lists of a format: kWords is the list, Format::modes or Format::layouts.
template <std::span<const std::string_view> Format::*kWords>
class FormatWord {
 public:
  /// Finds the word in the list of the format. nullopt if the list does not contain it.
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

/// The name of the word. Empty if there is no word.
template <class Word>
[[nodiscard]] std::string_view name_of(const std::optional<Word>& word) {
  return word ? word->name() : std::string_view();
}

}  // namespace fca
