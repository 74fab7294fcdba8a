// SPDX-License-Identifier: BSD-3-Clause
// What `convert` would make of a file for a program that does not read its format: `check --for` and `show --for` say it.
#pragma once

#include "conversion.h"

#include <fca/formats/consumers/consumer.h>

#include <string>
#include <string_view>

namespace fca::cli {

/// Converted in memory, as `convert FILE --to FORMAT --dry-run` does with what that program wants; without the written text.
[[nodiscard]] ConvertOutcome preview_conversion(const std::string& file, const ReadingOptions& reading,
                                                const consumers::Consumer& program, Console& console);

/// Cameras with what they cost in pixels, losses and defaults, each line behind `indent`.
[[nodiscard]] std::string preview_text(const ConvertOutcome& outcome, const std::string& indent);

}  // namespace fca::cli
