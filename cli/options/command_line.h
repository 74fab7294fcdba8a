// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/options.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

/// "fca-io NAME ...": a command as one would type it again, with those of its options (by name, "--to") that `keep` wants;
/// positional ones come first.
[[nodiscard]] std::string command_line(const std::vector<TypedOption>& options, std::string_view name,
                                       const std::function<bool(const std::string&)>& keep);

}  // namespace fca::cli
