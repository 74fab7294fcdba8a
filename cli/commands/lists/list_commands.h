// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/console.h"
#include "toolkit/reading.h"

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace fca::cli {

struct ListArguments {
  std::string file;  ///< models FILE
  ReadingOptions reading;
  bool json = false;
  bool markdown = false;
  bool ledger = false;
};

/// `formats`, `models` and `programs`: what is supported, from the registries.
void add_list_commands(CLI::App& app, ListArguments& arguments, std::function<ExitCode(Console&)>& run);

}  // namespace fca::cli
