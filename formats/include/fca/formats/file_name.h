// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace fca {

/// Longer names are cut: file systems end at 255 bytes, and an extension and the input's name go with it.
inline constexpr std::size_t kLongestFileName = 120;

/// A name from a file (a camera's) as part of a file's: it stays in its folder, is not hidden, and no terminal trips over it.
[[nodiscard]] std::string as_file_name(std::string_view name);

}  // namespace fca
