// SPDX-License-Identifier: BSD-3-Clause
#include "convert_command.h"

#include "batch.h"
#include "options/option_use.h"
#include "options/subcommand.h"
#include "shell/calibration_files.h"
#include "shell/output_name.h"
#include "shell/words.h"
#include "shell/written_outputs.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

std::optional<std::string> usage_error(const ConvertArguments& arguments, const std::vector<FoundFile>& files) {
  if (const std::optional<std::string> error = check(arguments.reading)) return error;
  if (arguments.in_place && arguments.into.empty()) {
    const std::string input = shell_word(arguments.inputs.front());
    return "--in-place is for --into BASE; to change the input itself: fca-io convert " + input + " --into " + input +
           " --in-place";
  }
  if (arguments.into.empty() && arguments.to.empty()) return "--to FORMAT is missing: " + format_names();
  if (const std::optional<std::string> error = problem_with(arguments)) return error;
  if (arguments.provenance && arguments.no_provenance) return "--provenance and --no-provenance contradict each other";
  if (arguments.in_place && !arguments.output.empty()) return "--in-place writes BASE itself; leave out -o";
  if (arguments.max_error_px && !(*arguments.max_error_px >= 0.0)) return "--max-error wants a number of pixels";
  const bool many = !arguments.reading.join && (files.size() > 1 || (files.size() == 1 && !files.front().named));
  if (many && !arguments.into.empty()) return "--into wants one input, or several that are one rig (--join)";
  const bool one_path =
      !arguments.output.empty() && arguments.output.find('{') == std::string::npos && !names_folder(arguments.output);
  constexpr std::string_view kOneRig = "; parts of one calibration go behind --with, cameras of one rig want --join";
  if (many && one_path)
    return "several inputs need -o FOLDER/ or a pattern such as -o 'out/{stem}.{format}.yaml'" + std::string(kOneRig);
  if (many && arguments.output.empty() && !arguments.json)
    return "several inputs need -o FOLDER/ (or --json)" + std::string(kOneRig);
  return problem_with_pattern(arguments.output);
}

/// Reading anything else may wait for ever.
bool is_regular(const FoundFile& file) {
  std::error_code ignored;
  return fs::is_regular_file(file.path, ignored);
}

ExitCode run_convert(const ConvertArguments& arguments, Console& console) {
  if (const std::optional<std::string> problem = problem_with_patterns(arguments.inputs))
    return console.refuse(ExitCode::kIo, *problem);
  const std::vector<FoundFile> files = walk(arguments.inputs);
  if (const std::optional<std::string> error = usage_error(arguments, files)) return console.refuse(ExitCode::kUsage, *error);
  const HeldInterrupt interrupt(files.size() > 1 && std::ranges::all_of(files, is_regular));
  Batch batch = convert_batch(files, arguments, interrupt, console);
  std::vector<ConvertOutcome>& outcomes = batch.outcomes;
  if (outcomes.empty() && batch.left == 0) {
    return console.refuse(ExitCode::kBadInput, "no calibration with a camera in " + enumerated(arguments.inputs) + " (" +
                                                   counted(batch.skipped, "file") + " looked at)");
  }
  if (const std::optional<std::string> error = opencv_model_without_use(arguments, outcomes))
    return console.refuse(ExitCode::kUsage, *error);
  if (collide(outcomes, console)) return ExitCode::kUsage;

  ExitCode code = ExitCode::kGood;
  const bool in_full = is_told_in_full(outcomes.size() + batch.skipped + batch.left);
  const bool file_on_stdout = (arguments.output.empty() && !arguments.in_place) || arguments.output == "-";
  if (!arguments.dry_run) remove_leftovers_beside(outcomes);
  std::size_t tried = 0;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    ConvertOutcome& outcome = outcomes[i];
    if (i == tried) {
      if (outcomes.size() > 1 && interrupt.asked()) {
        batch.unwritten = outcomes.size() - tried;
        break;
      }
      tried += arguments.dry_run ? 1 : write_outputs(arguments, std::span(outcomes).subspan(i), console);
    }
    if (!arguments.json) {
      if (!outcome.outputs.empty() && in_full) {
        const std::string report = convert_text(outcome, !arguments.dry_run);
        file_on_stdout && !arguments.dry_run ? console.say_aside(report) : console.say(report);
      }
      in_full ? console.show(outcome.diagnostics) : console.show_errors(outcome.diagnostics);
    }
    code = worse(code, outcome.code);
  }
  if (arguments.json) console.out(convert_json(outcomes, console));
  const bool several = outcomes.size() > 1 || batch.skipped > 0 || batch.left > 0;
  if (several) {
    const std::string text = batch_text(batch, !arguments.dry_run);
    arguments.json ? console.say_aside(text) : console.say(text);
  }
  return code;
}

void add_options(CLI::App& command, ConvertArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command
      .add_option("INPUT", arguments.inputs, "Calibration file(s), folders or patterns ('rigs/*.yaml'); '-' is standard input")
      ->required();
  command.add_option("--to", arguments.to, "The format to write")->type_name("FORMAT");
  command
      .add_option("--model", arguments.model,
                  "The camera model to write (default: kept, else the best that the stock program reads)")
      ->type_name("MODEL");
  command
      .add_option(
          "-o,--output", arguments.output,
          "A path, a folder, or a pattern with {stem}, {extension}, {folder}, {camera}, {format} (default: standard output)")
      ->type_name("PATH");
  add_reading_options(command, arguments.reading);
  add_lens_circle_option(command, arguments.reading);
  add_join_option(command, arguments.reading);
  add_imu_option(command, arguments.reading);
  add_writing_options(command, arguments);
  command.add_flag("--in-place", arguments.in_place, "With --into: change BASE itself");
  command.add_flag("--provenance", arguments.provenance,
                   "Say in a comment where the file comes from even in an edited file (fresh ones say it anyway)");
  command.add_flag("--no-provenance", arguments.no_provenance, "Leave out that comment");
  command
      .add_option(
          "--max-error", arguments.max_error_px,
          "Fail (exit 1, nothing written) if the largest error of what was scored is more (the max of the report: "
          "polished to where it really is, between the pixels, too), or if a part of the image (of the lens, if --max-angle or "
          "--lens-circle says where it ends), more than a thousandth of it or what the fit had to give up, has no pixel in the "
          "new model")
      ->type_name("PX")
      ->check(decimal_number());
  command.add_flag("--strict", arguments.strict, "Fail if anything of the input cannot be carried");
  CLI::Option* verify = command.add_flag_function(
      "--verify", [](std::int64_t) {},
      "Ask the real program's reader about the bytes before they are put in place (the default)");
  command.add_flag("--no-verify", arguments.no_verify, "Do not ask it")->excludes(verify);
  command
      .add_option("--jobs", arguments.jobs,
                  "Inputs, or cameras of one, worked on at the same time (default: as many as there are processors)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--dry-run", arguments.dry_run, "Report, write nothing");
  command.add_flag("--force", arguments.force, "Overwrite existing files");
  command.add_flag("--fsync", arguments.fsync, "Force the files to disk before they replace old ones (all of a batch at once)");
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.footer(
      "Example:\n"
      "  fca-io convert camchain.yaml --with imu.yaml --to orbslam3 -o settings.yaml\n"
      "  fca-io convert camchain.yaml --to orbslam3 --model eucm --max-angle 97.5 -o eucm.yaml\n");
  command.callback([&arguments, &run] { run = [&arguments](Console& console) { return run_convert(arguments, console); }; });
}

}  // namespace

void add_convert_command(CLI::App& app, ConvertArguments& arguments, std::function<ExitCode(Console&)>& run) {
  add_subcommand(app, "convert", "Convert a calibration to another format, and to another camera model if need be",
                 [&arguments, &run](CLI::App& command) { add_options(command, arguments, run); });
}

}  // namespace fca::cli
