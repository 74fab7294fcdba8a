// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

/// What may stand where the last of `words`, those after the program's name, is being typed.
struct Completion {
  std::vector<std::string> words;
  bool files = false;  ///< Also the paths of files.
};

/// Of all subcommands.
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

/// `command`: the one that the first word names, with its options defined; null: none.
[[nodiscard]] Completion completion_of(const CLI::App& app, const CLI::App* command, std::span<const std::string> words);

}  // namespace fca::cli
