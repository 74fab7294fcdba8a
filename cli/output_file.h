// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>

namespace fca::cli {

/// A file to be written.
struct OutputFile {
  std::string path;
  std::string bytes;
};

/// Removes from a folder (empty: the current one) what a program that was killed while it wrote there has left.
void remove_leftovers(const std::string& folder);

/// Writes files so that all their paths hold the old content or the new, never half: temporary files beside them first, then,
/// when all of them are complete, renames. Symbolic links are followed, permissions of existing files kept. Devices and pipes
/// are written directly, last. Returns what went wrong; then no temporary file stays.
[[nodiscard]] std::optional<std::string> write_files(std::span<const OutputFile> files, bool overwrite, bool sync);

}  // namespace fca::cli
