// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/message.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca {

/// A file to write.
struct OutputFile {
  std::string path;
  std::string bytes;
};

/// Removes temporary files that killed writers have left in a folder (empty: the current one).
void remove_leftovers(const std::string& folder);

/// Writes files so that each path has either its old or its new content, never a part: writes temporary files first and renames
/// them when all are complete. Follows symbolic links, and keeps the permissions of existing files. Writes devices and pipes
/// directly, last. Returns an error message, after removing the temporary files, or nullopt. `sync`: safe also if the power
/// fails.
[[nodiscard]] std::optional<Message> write_files(std::span<const OutputFile> files, bool overwrite, bool sync);

/// Writes several sets of files, each of which succeeds or fails by itself; returns the error of each, or nullopt. Writes up to
/// `jobs` sets (parallel_for.h) at the same time; two sets must not contain the same path. With `sync`, all sets are forced to
/// disk at once, which takes as long as a single one. All files stay open until they are renamed.
[[nodiscard]] std::vector<std::optional<Message>> write_sets(std::span<const std::span<const OutputFile>> sets, bool overwrite,
                                                             bool sync, std::size_t jobs);

}  // namespace fca
