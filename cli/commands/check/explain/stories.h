// SPDX-License-Identifier: BSD-3-Clause
// The stories behind the codes of findings: the command's documentation.
#pragma once

#include <string_view>

namespace fca::cli {

/// Formula, thresholds and their reasons, in lines; empty of a code that no finding has.
[[nodiscard]] std::string_view story_of(std::string_view code);

}  // namespace fca::cli
