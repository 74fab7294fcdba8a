// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/writing_options.h"
#include "shell/console.h"
#include "toolkit/reading.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

/// The model "all": every model beside the others.
struct ReportArguments : WritingOptions {
  std::vector<std::string> inputs;
  ReadingOptions reading;
  std::string output;
  bool force = false;
};

void add_report_command(CLI::App& app, ReportArguments& arguments, std::function<ExitCode(Console&)>& run);

}  // namespace fca::cli
