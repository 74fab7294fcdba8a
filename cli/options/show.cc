// SPDX-License-Identifier: BSD-3-Clause
#include "show.h"

#include "inputs.h"
#include "output.h"
#include "program.h"

#include <fca/formats/text/prose.h>

namespace fca::cli {

namespace {

std::optional<std::string> usage_error(const ReadRequest& request) {
  const Inputs& inputs = request.inputs;
  std::vector<std::string> changes = given_changes(inputs);
  if (inputs.length_unit_m) changes.emplace_back("--unit");
  if (request.program == nullptr || changes.empty()) return std::nullopt;
  return "--for reads a file unchanged: " + text::enumerated(changes, "and") + " has no effect with it";
}

}  // namespace

void add_show_options(Options& options, ShowArguments& arguments) {
  ReadRequest& request = arguments.request;
  options.positional("FILE", "Calibration file(s); '-' is standard input", request.inputs.files);
  add_input_options(options, request.inputs);
  add_join_option(options, request.inputs);
  add_imu_option(options, request.inputs);
  add_program_option(options,
                     "How this program reads the file: whether it loads the file, which cameras it sees, and how far their "
                     "pixels are from what the file means: " +
                         text::enumerated(program_ids(), "or"),
                     request.program);
  options.group(OptionGroup::kOutput);
  add_json_option(options, arguments.json);
  options.footer("Example:\n  fca-io show camchain.yaml --with imu.yaml\n  fca-io show settings.yaml --for orbslam3\n");
  options.afterwards([&request] { return usage_error(request); });
}

}  // namespace fca::cli
