// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace fca::cli {

/// A file to look at.
struct FoundFile {
  std::string path;
  bool named = true;  ///< By the user; false: met in a folder.
};

/// The paths with patterns (* ? [...], where no shell has expanded them) resolved and folders walked: files in them by name
/// that end as calibrations do (.yaml .yml .xml .json .txt .ini), without hidden ones.
[[nodiscard]] std::vector<FoundFile> walk(const std::vector<std::string>& paths);

}  // namespace fca::cli
