// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output_name.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

/// A file to look at.
struct FoundFile {
  std::string path;
  bool named = true;  ///< By the user; false: met in a folder or by a pattern.
};

/// Why a path finds nothing: a pattern (* ? [...]) that fits no file.
[[nodiscard]] std::optional<std::string> problem_with_patterns(const std::vector<std::string>& paths);

/// Which files of a folder are wanted, by their extension with its point.
using WantedExtension = bool (*)(std::string_view extension);

/// The paths with patterns (where no shell has expanded them) resolved and folders walked: files in them by name that are
/// wanted, without hidden ones. Each file once, however often it is met. Default: those that end as calibrations do (.yaml .yml
/// .xml .json .txt .ini).
[[nodiscard]] std::vector<FoundFile> walk(const std::vector<std::string>& paths,
                                          WantedExtension wanted = &is_calibration_extension);
/// The same for calibrations, but a folder that is one rig (rig_files_in) is one of them, whole.
[[nodiscard]] std::vector<FoundFile> walk_rigs(const std::vector<std::string>& paths);

}  // namespace fca::cli
