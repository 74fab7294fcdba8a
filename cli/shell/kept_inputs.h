// SPDX-License-Identifier: BSD-3-Clause
// Outputs next to inputs: a command does not write over the files that it reads, --force or not.
#pragma once

#include "console.h"

#include <fca/toolkit/inputs.h>

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace fca::cli {

/// Files that stay as they are. A symbolic link counts as the file it points to; "-" and "" are no files.
class KeptInputs {
 public:
  /// The images of --lens-circle.
  explicit KeptInputs(const Inputs& inputs);
  /// All that was read until now: calibrations with the files they name, and those images.
  KeptInputs(const Console& console, const Inputs& inputs);

  void add(std::span<const std::string> files);
  /// Is the output one of them?
  [[nodiscard]] bool hold(const std::string& output) const;
  /// "PATH is an input; name another place" where an output would replace one of them.
  [[nodiscard]] std::optional<std::string> problem_with(const std::string& output) const;

 private:
  void add(const std::string& file);

  std::set<std::filesystem::path> files_;
};

}  // namespace fca::cli
