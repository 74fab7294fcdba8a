// SPDX-License-Identifier: BSD-3-Clause
// The stories behind the codes of findings: the command's documentation.
#pragma once

#include <span>
#include <string_view>

namespace fca::cli {

struct Story {
  std::string_view code;
  std::string_view text;  ///< Formula, thresholds and their reasons, in lines.
};

/// By code.
[[nodiscard]] std::span<const Story> stories();

/// Empty of a code that has none: of findings each has one.
[[nodiscard]] std::string_view story_of(std::string_view code);

}  // namespace fca::cli
