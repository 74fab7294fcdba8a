// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace fca {

/// How the comment begins that a fresh file has above a value which no input specifies.
inline constexpr std::string_view kDefaultComment = "# Default. ";

}  // namespace fca
