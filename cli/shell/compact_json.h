// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace fca::cli {

/// A document of Json in one line, without a line break at its end.
[[nodiscard]] std::string compact(const std::string& document);

}  // namespace fca::cli
