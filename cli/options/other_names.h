// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

/// What other programs call a command.
struct OtherName {
  std::string_view typed;
  std::string_view meant;
};

inline constexpr std::array kOtherNames = {OtherName{"diff", "compare"}, OtherName{"undistort", "remap"},
                                           OtherName{"help", "--help"}};

/// The words with the first one's usual name; `help COMMAND` is `COMMAND --help`.
[[nodiscard]] std::vector<std::string> in_usual_names(std::vector<std::string> words);

}  // namespace fca::cli
