// SPDX-License-Identifier: BSD-3-Clause
#include "show_command.h"
#include "options/subcommand.h"
#include "shell/words.h"

#include <fca/rig/first_camera.h>

#include <algorithm>

#include <CLI/CLI.hpp>

namespace fca::cli {

ShownFile read_shown(const std::vector<std::string>& files, const ShowArguments& arguments, Console& console) {
  ShownFile shown;
  shown.file = enumerated(files, "and");
  shown.limit_deg = arguments.reading.max_angle_deg.value_or(shown.limit_deg);
  shown.calibration = read_input(files, arguments.reading, console, shown.diagnostics);
  if (shown.calibration) {
    if (arguments.reading.cameras) {
      Rig& rig = shown.calibration->rig;
      rig.poses = poses_of_first(rig);
      if (!shown.calibration->poses_without_unit.empty()) shown.calibration->poses_without_unit = rig.poses;
    }
    shown.readers = ask_readers(shown.calibration->format->id, shown.calibration->documents.front().source().bytes,
                                !shown.calibration->rig.cameras.empty(), {{}, arguments.reading.opencv_model});
    if (!arguments.program.empty()) {
      shown.asked = ask_program(*find_program(arguments.program), *shown.calibration, max_angle_rad(arguments.reading),
                                arguments.reading.opencv_model);
    }
  }
  return shown;
}

namespace {

std::optional<std::string> problem_with(const ShowArguments& arguments) {
  if (const std::optional<std::string> error = check(arguments.reading)) return error;
  if (arguments.program.empty()) return std::nullopt;
  if (find_program(arguments.program) == nullptr) return unknown_word("program", arguments.program, program_ids());
  if (arguments.reading.join || arguments.reading.cameras || changes_images(arguments.reading))
    return "--for is about a file as it stands: --join, --camera, --crop, --binning and --resize have no use beside it";
  return std::nullopt;
}

ExitCode run_show(const ShowArguments& arguments, Console& console) {
  if (const std::optional<std::string> error = problem_with(arguments)) return console.refuse(ExitCode::kUsage, *error);
  ExitCode code = ExitCode::kGood;
  std::vector<ShownFile> files;
  for (const std::vector<std::string>& group : grouped(arguments.files, arguments.reading)) {
    files.push_back(read_shown(group, arguments, console));
    code = worse(code, code_of(files.back().diagnostics));
    if (!arguments.json) {
      if (files.back().calibration) console.say((files.size() > 1 ? "\n" : "") + show_text(files.back()));
      console.show(files.back().diagnostics);
    }
  }
  if (arguments.json) console.out(show_json(files, console));
  return code;
}

void add_options(CLI::App& command, ShowArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command.add_option("FILE", arguments.files, "Calibration file(s); '-' is standard input")->required();
  add_reading_options(command, arguments.reading);
  add_join_option(command, arguments.reading);
  add_imu_option(command, arguments.reading);
  command
      .add_option("--for", arguments.program,
                  "What this program makes of the file: whether it loads it, which cameras it sees, how far they are from what "
                  "the file means: " +
                      enumerated(program_ids(), "or"))
      ->type_name("PROGRAM");
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.footer("Example:\n  fca-io show camchain.yaml --with imu.yaml\n  fca-io show settings.yaml --for orbslam3\n");
  command.callback([&arguments, &run] { run = [&arguments](Console& console) { return run_show(arguments, console); }; });
}

}  // namespace

std::string name_in(const Format& format, const StoredModel& row) {
  return std::string(format.program) + " " + std::string(row.file_name) + (row.stock ? "" : " (forks)");
}

std::vector<std::string> names_elsewhere(std::string_view model) {
  std::vector<std::string> names;
  for (const Format& format : all_formats()) {
    for (const StoredModel& row : format.models) {
      const std::string name = name_in(format, row);
      if (row.model == model && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

void add_show_command(CLI::App& app, ShowArguments& arguments, std::function<ExitCode(Console&)>& run) {
  add_subcommand(app, "show", "What a file means: cameras, models, fields of view, poses, IMU, and who reads it",
                 [&arguments, &run](CLI::App& command) { add_options(command, arguments, run); });
}

}  // namespace fca::cli
