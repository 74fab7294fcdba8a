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
  std::string bytes;  ///< The whole new content.
};

/// Removes temporary files that killed programs have left in a folder. An empty path is the current folder.
void remove_leftovers(const std::string& folder);

/// Writes files so that each path has either its old or its new content, never a part of it. For this, writes temporary files
/// first and renames them when all are complete. Follows symbolic links, and keeps the permissions of existing files. Writes to
/// devices and pipes directly, after all other files. `overwrite`: existing files may be replaced. `sync`: the files are also
/// safe if the power fails. Returns nullopt, or an error message after it has removed the temporary files.
[[nodiscard]] std::optional<Message> write_files(std::span<const OutputFile> files, bool overwrite, bool sync);

/// Writes several sets of files like write_files(). Each set succeeds or fails by itself. Returns one element per set: its
/// error message, or nullopt. Writes up to `jobs` sets at the same time (0: see parallel_for.h). Two sets must not contain the
/// same path. With `sync`, a single sync forces all sets to the disk, which takes as long as one set. All files stay open until
/// they are renamed.
[[nodiscard]] std::vector<std::optional<Message>> write_sets(std::span<const std::span<const OutputFile>> sets, bool overwrite,
                                                             bool sync, std::size_t jobs);

}  // namespace fca
