// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

#include <string>

namespace fca::cli {

/// What converting would give: its verdict, and what a user must act on.
[[nodiscard]] std::string preview_text(const ConvertResult& outcome);

}  // namespace fca::cli
