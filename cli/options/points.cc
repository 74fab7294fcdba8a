// SPDX-License-Identifier: BSD-3-Clause
#include "points.h"

#include "inputs.h"
#include "output.h"

namespace fca::cli {

void add_project_options(Options& options, const std::string& footer, ProjectArguments& arguments) {
  options.one_positional("FILE", "Calibration file", arguments.inputs.files);
  add_input_options(options, arguments.inputs);
  options.group(OptionGroup::kOutput);
  add_json_option(options, arguments.json);
  options.footer(footer);
  options.afterwards([&arguments]() -> std::optional<std::string> {
    if (reads_of_standard_input(arguments.inputs.files) == 0) return std::nullopt;
    return "standard input holds the points, so the calibration must be a file";
  });
}

}  // namespace fca::cli
