// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include "shell/words.h"

namespace fca::cli {

std::string command_line(const std::vector<TypedOption>& options, std::string_view name,
                         const std::function<bool(const std::string&)>& keep) {
  std::string positional;
  std::string named;
  for (const TypedOption& option : options) {
    if (!keep(option.name)) continue;
    if (option.values.empty()) named += " " + option.name;
    for (const std::string& value : option.values) {
      if (option.positional) {
        positional += " " + shell_word(value);
      } else {
        named += " " + option.name + " " + shell_word(value);
      }
    }
  }
  return "fca-io " + std::string(name) + positional + named;
}

}  // namespace fca::cli
