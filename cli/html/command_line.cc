// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include "shell/words.h"

#include <CLI/CLI.hpp>

namespace fca::cli {

std::string command_line(const CLI::App& command, std::string_view name, const std::function<bool(const std::string&)>& keep) {
  std::string positional;
  std::string options;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || !keep(option->get_name())) continue;
    for (const std::string& value : option->reduced_results()) {
      if (option->get_positional()) {
        positional += " " + shell_word(value);
      } else {
        options += " " + option->get_name() + (option->get_items_expected_max() > 0 ? " " + shell_word(value) : "");
      }
    }
  }
  return "fca-io " + std::string(name) + positional + options;
}

}  // namespace fca::cli
