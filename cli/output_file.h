// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fca::cli {

/// Writes a file so that its path holds the old content or the new, never half: a temporary file beside it, then a rename.
/// Symbolic links are followed, permissions of an existing file kept. Devices and pipes are written directly. Returns what went
/// wrong.
[[nodiscard]] std::optional<std::string> write_file(const std::string& path, std::string_view bytes, bool overwrite, bool sync);

}  // namespace fca::cli
