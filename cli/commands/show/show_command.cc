// SPDX-License-Identifier: BSD-3-Clause
#include "show_command.h"

#include "options/inputs.h"
#include "options/output.h"
#include "options/program.h"
#include "shell/words.h"

#include <memory>
#include <utility>

namespace fca::cli {

ShownFile as_shown(Reading reading, const Inputs& inputs) {
  ShownFile shown;
  static_cast<Reading&>(shown) = std::move(reading);
  shown.file = enumerated(inputs.files, "and");
  if (inputs.max_angle_rad) shown.limit_deg = *inputs.max_angle_rad * kDegreesPerRadian;
  return shown;
}

ShownFile read_shown(const ReadRequest& request, Files& files) { return as_shown(read(request, files), request.inputs); }

namespace {

std::optional<std::string> usage_error(const ReadRequest& request) {
  const Inputs& inputs = request.inputs;
  if (const std::optional<std::string> error = problem_with(inputs)) return error;
  std::vector<std::string> changes = given_changes(inputs);
  if (inputs.length_unit_m) changes.emplace_back("--unit");
  if (request.program == nullptr || changes.empty()) return std::nullopt;
  return "--for is about a file as it stands: " + enumerated(changes, "and") + " has no use beside it";
}

ExitCode run_show(const ShowArguments& arguments, Console& console) {
  if (const std::optional<std::string> error = usage_error(arguments.request)) return console.refuse(ExitCode::kUsage, *error);
  ExitCode code = ExitCode::kGood;
  std::vector<ShownFile> files;
  for (const Inputs& inputs : grouped(arguments.request.inputs)) {
    files.push_back(read_shown({inputs, arguments.request.program}, console.files()));
    code = worse(code, exit_code(files.back().status));
    if (!arguments.json) {
      if (files.back().calibration || !files.back().readings.empty())
        console.say((files.size() > 1 ? "\n" : "") + show_text(files.back()));
      console.show(files.back().diagnostics);
    }
  }
  if (arguments.json) console.out(show_json(files, console));
  return code;
}

void add_options(Options& options, ShowArguments& arguments) {
  ReadRequest& request = arguments.request;
  options.positional("FILE", "Calibration file(s); '-' is standard input", request.inputs.files);
  add_input_options(options, request.inputs);
  add_join_option(options, request.inputs);
  add_imu_option(options, request.inputs);
  add_program_option(options,
                     "What this program makes of the file: whether it loads it, which cameras it sees, how far they are from "
                     "what the file means: " +
                         enumerated(program_ids(), "or"),
                     request.program);
  options.group(OptionGroup::kOutput);
  add_json_option(options, arguments.json);
  options.footer("Example:\n  fca-io show camchain.yaml --with imu.yaml\n  fca-io show settings.yaml --for orbslam3\n");
}

}  // namespace

void add_show_command(Application& application) {
  application.add("show", "What a file means: cameras, models, fields of view, poses, IMU, and who reads it",
                  [](Options& options) -> RunCommand {
                    const auto arguments = std::make_shared<ShowArguments>();
                    add_options(options, *arguments);
                    return [arguments](const TypedOptions&, Console& console) { return run_show(*arguments, console); };
                  });
}

}  // namespace fca::cli
