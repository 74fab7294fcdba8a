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

struct ProjectArguments {
  std::string file;
  ReadingOptions reading;
  bool json = false;
};

/// `project` and `unproject`: numbers per line on standard input, results per line on standard output.
void add_project_commands(CLI::App& app, ProjectArguments& arguments, std::function<ExitCode(Console&)>& run);

}  // namespace fca::cli
