// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

#include <string>

namespace fca::cli {

/// What converting would give: cameras with what they cost in pixels, losses and defaults, each line behind `indent`.
[[nodiscard]] std::string preview_text(const ConvertResult& outcome, const std::string& indent);

}  // namespace fca::cli
