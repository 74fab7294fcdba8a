// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/message.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fca {

/// A file to be written.
struct OutputFile {
  std::string path;
  std::string bytes;
};

/// Removes from a folder (empty: the current one) what a program that was killed while it wrote there has left.
void remove_leftovers(const std::string& folder);

/// Writes files so that all their paths hold the old content or the new, never half: temporary files beside them first, then,
/// when all of them are complete, renames. Symbolic links are followed, permissions of existing files kept. Devices and pipes
/// are written directly, last. Returns what went wrong; then no temporary file stays. `sync`: also if the power fails.
[[nodiscard]] std::optional<Message> write_files(std::span<const OutputFile> files, bool overwrite, bool sync);

/// The same of several sets, each of which is written or not for itself: what went wrong with each. Up to `jobs`
/// (parallel_for.h) are written at the same time: no two of them hold the same path. All are forced to disk at once, which
/// takes as long as one alone; until they are in their places all files are open.
[[nodiscard]] std::vector<std::optional<Message>> write_sets(std::span<const std::span<const OutputFile>> sets, bool overwrite,
                                                             bool sync, std::size_t jobs);

}  // namespace fca
