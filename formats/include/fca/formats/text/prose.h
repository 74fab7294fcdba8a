// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::text {

/// "a, b and c"
[[nodiscard]] std::string enumerated(std::span<const std::string> parts, std::string_view last_word = "and");

/// The text, or so much of its beginning that it fits into a line of a list, with "...".
[[nodiscard]] std::string shortened(std::string_view text);

/// Those of `names` that `typed` probably meant, at most three: it begins them, or at most a third of its letters are wrong;
/// one letter after the first of a word of three and fewer.
[[nodiscard]] std::vector<std::string> nearest(std::string_view typed, std::span<const std::string> names);

/// Is `typed` the word `meant` but for a common mistake: a letter lost, too many, wrong, or exchanged with its neighbour, or
/// the case of letters? Digits are no letters (Camera1 is not Camera2), and short words (k1) have too many neighbours.
[[nodiscard]] bool is_misspelling(std::string_view typed, std::string_view meant);

/// A word of a command as a shell takes it, in quotes where it needs them: 'my files/camchain.yaml'.
[[nodiscard]] std::string shell_word(std::string_view word);

}  // namespace fca::text
