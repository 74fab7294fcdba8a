// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include "shell/words.h"

namespace fca::cli {

std::string command_line(const TypedOptions& options, std::string_view name,
                         const std::function<bool(const TypedOption&)>& keep) {
  std::string line(name);
  for (const TypedOption& option : options) {
    if (!keep(option)) continue;
    if (!option.positional) line += " " + option.name;
    if (option.value) line += " " + shell_word(*option.value);
  }
  return line;
}

}  // namespace fca::cli
