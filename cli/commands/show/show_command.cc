// SPDX-License-Identifier: BSD-3-Clause
#include "show_command.h"

#include "options/inputs.h"
#include "shell/words.h"

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

ExitCode run_show(const ShowArguments& arguments, Console& console) {
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

}  // namespace

void add_show_command(Application& application) {
  application.add<ShowArguments>("show", "What a file means: cameras, models, fields of view, poses, IMU, and who reads it",
                                 &add_show_options, &run_show);
}

}  // namespace fca::cli
