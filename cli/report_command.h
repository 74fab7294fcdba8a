// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "console.h"
#include "reading.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

struct ReportArguments {
  std::vector<std::string> inputs;
  ReadingOptions reading;
  std::string to;
  std::string model;  ///< "all": every model beside each other.
  std::string objective = "rms";
  bool every_pixel = false;
  std::string output;
  bool force = false;
};

void add_report_command(CLI::App& app, ReportArguments& arguments, std::function<ExitCode(Console&)>& run);

}  // namespace fca::cli
