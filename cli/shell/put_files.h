// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "console.h"
#include "toolkit/save/output_file.h"

#include <optional>
#include <span>

namespace fca::cli {

/// Puts files in their places, all or none, and lets the console know: a report that cannot be printed is then no failure to
/// write. What went wrong, if anything did.
[[nodiscard]] inline std::optional<Message> put_files(std::span<const OutputFile> files, bool overwrite,
                                                      const Console& console) {
  std::optional<Message> problem = write_files(files, overwrite, false);
  if (!problem && !files.empty()) console.note_written();
  return problem;
}

}  // namespace fca::cli
