// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

/// "NAME --to FORMAT ...": a command as one would type it again, after the program's name, with those of its options that
/// `keep` wants.
[[nodiscard]] std::string command_line(const TypedOptions& options, std::string_view name,
                                       const std::function<bool(const TypedOption&)>& keep);

}  // namespace fca::cli
