// SPDX-License-Identifier: BSD-3-Clause
#include "convert_command.h"

#include "batch.h"
#include "calibration_files.h"
#include "option_use.h"
#include "output_name.h"
#include "words.h"
#include "written_outputs.h"

#include <fca/formats/text/numbers.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// An option that is one format's own, as an error if that one does not know the value.
std::optional<std::string> not_among(const std::string& value, std::string_view kind, std::string_view owner,
                                     std::span<const std::string_view> Format::*values) {
  if (value.empty()) return std::nullopt;
  const Format* format = find_format(owner);
  const std::span<const std::string_view> known = format != nullptr ? format->*values : std::span<const std::string_view>();
  if (std::ranges::find(known, value) != known.end()) return std::nullopt;
  const std::vector<std::string> names(known.begin(), known.end());
  return unknown_word(kind, value, names);
}

/// The key of two settings.
std::optional<std::string> key_set_twice(const std::vector<std::string>& settings) {
  std::set<std::string> keys;
  for (const std::string& setting : settings) {
    const std::string key = setting.substr(0, setting.find('='));
    if (!keys.insert(key).second) return key;
  }
  return std::nullopt;
}

std::optional<std::string> usage_error(const ConvertArguments& arguments, const std::vector<FoundFile>& files) {
  if (const std::optional<std::string> error = check(arguments.reading)) return error;
  if (arguments.in_place && arguments.into.empty()) {
    const std::string input = shell_word(arguments.inputs.front());
    return "--in-place is for --into BASE; to change the input itself: fca-io convert " + input + " --into " + input +
           " --in-place";
  }
  if (arguments.into.empty() && arguments.to.empty()) return "--to FORMAT is missing: " + format_names();
  if (!arguments.to.empty() && find_format(arguments.to) == nullptr) return unknown_format(arguments.to);
  if (arguments.provenance && arguments.no_provenance) return "--provenance and --no-provenance contradict each other";
  if (arguments.in_place && !arguments.output.empty()) return "--in-place writes BASE itself; leave out -o";
  if (!arguments.model.empty() && find_model(arguments.model) == nullptr) return unknown_model(arguments.model);
  if (arguments.objective != "rms" && arguments.objective != "max")
    return "unknown objective '" + arguments.objective + "'; there are rms and max";
  if (arguments.fps && !(*arguments.fps > 0.0 && *arguments.fps < 1e6))
    return "--fps wants a rate in Hz, more than 0 and below 1e6";
  if (arguments.baseline_m && problem_with_baseline(*arguments.baseline_m))
    return "--baseline wants a positive number of metres";
  for (const std::string& setting : arguments.settings) {
    if (setting.find('=') == std::string::npos || setting.starts_with('='))
      return "--set wants KEY=VALUE, such as Viewer.PointSize=3.0; got '" + setting + "'";
  }
  if (const std::optional<std::string> twice = key_set_twice(arguments.settings))
    return "--set " + *twice + " comes twice; one value can stand there";
  if (arguments.max_error_px && !(*arguments.max_error_px >= 0.0)) return "--max-error wants a number of pixels";
  if (const Format* to = find_format(arguments.to)) {
    if (const auto error = option_without_use(arguments, *to)) return error;
  }
  if (const auto error = not_among(arguments.sensor, "sensor mode", "orbslam3", &Format::modes)) return error;
  if (const auto error = not_among(arguments.orbslam3_layout, "layout", "orbslam3", &Format::layouts)) return error;
  if (const auto error = not_among(arguments.opencv_layout, "layout", "opencv", &Format::layouts)) return error;
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

}  // namespace

void add_convert_command(CLI::App& app, ConvertArguments& arguments, std::function<ExitCode(Console&)>& run) {
  CLI::App& command =
      *app.add_subcommand("convert", "Convert a calibration to another format, and to another camera model if need be");
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
  add_join_option(command, arguments.reading);
  add_imu_option(command, arguments.reading);
  command
      .add_option("--sensor", arguments.sensor,
                  "orbslam3: mono, stereo, rgbd, mono-inertial or stereo-inertial (default: the richest the input serves)")
      ->type_name("MODE");
  command
      .add_option("--orbslam3-layout", arguments.orbslam3_layout,
                  "v1 (stock V1.0), old (before V1.0), orbslam2 or slam_no_opt (default: the input's, else v1)")
      ->type_name("LAYOUT");
  command
      .add_option("--opencv-layout", arguments.opencv_layout,
                  "calibration, stereo, omnidir, cameras or left-right (default: what the cameras need)")
      ->type_name("LAYOUT");
  command.add_option("--into", arguments.into, "Write what the input says into this file's text; its format is --to")
      ->type_name("BASE");
  command
      .add_option("--objective", arguments.objective,
                  "What a fit makes small: rms, or max, the error of the worst pixel (the report says what that costs in rms)")
      ->type_name("rms|max");
  command.add_flag("--every-pixel", arguments.every_pixel, "Judge by every pixel, not by a lattice of about 5,000 points");
  command.add_flag("--anew", arguments.anew, "Write a fresh file even where the input's own text could be edited; comments go");
  command.add_flag("--in-place", arguments.in_place, "With --into: change BASE itself");
  command.add_option("--fps", arguments.fps, "Frame rate, for formats that state it")->type_name("HZ")->check(decimal_number());
  command.add_option("--baseline", arguments.baseline_m, "Baseline of a rectified pair or depth sensor")
      ->type_name("METRES")
      ->check(decimal_number());
  take_one_each_time(
      *command
           .add_option("--set", arguments.settings,
                       "A value of the written file that no calibration states; KEY may be nested (cam0/rostopic); repeatable")
           ->type_name("KEY=VALUE"));
  command.add_flag("--provenance", arguments.provenance,
                   "Say in a comment where the file comes from even in an edited file (fresh ones say it anyway)");
  command.add_flag("--no-provenance", arguments.no_provenance, "Leave out that comment");
  command
      .add_option("--max-error", arguments.max_error_px,
                  "Fail (exit 1, nothing written) if the largest error of what was scored is more (the max of the report: "
                  "polished to where it really is, between the pixels, too), or if a part of the image (within --max-angle, "
                  "if given) has no pixel in the new model")
      ->type_name("PX")
      ->check(decimal_number());
  command.add_flag("--strict", arguments.strict, "Fail if anything of the input cannot be carried");
  CLI::Option* verify = command.add_flag_function(
      "--verify", [](std::int64_t) {},
      "Ask the real program's reader about the bytes before they are put in place (the default)");
  command.add_flag("--no-verify", arguments.no_verify, "Do not ask it")->excludes(verify);
  command.add_option("--jobs", arguments.jobs, "Inputs converted at the same time (default: as many as there are processors)")
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
  command.callback([&] { run = [&arguments](Console& console) { return run_convert(arguments, console); }; });
}

}  // namespace fca::cli
