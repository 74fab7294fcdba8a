// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

/// The values that an option of such a type may have ("FORMAT", "MODEL", "rms|max"), for somebody who types `words`. Empty:
/// any, or the path of a file.
[[nodiscard]] std::vector<std::string> candidates(std::string_view type, std::span<const std::string> words);

/// Is the value a path?
[[nodiscard]] bool is_path_type(std::string_view type);

}  // namespace fca::cli
