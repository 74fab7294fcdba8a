// SPDX-License-Identifier: BSD-3-Clause
#include "report_command.h"

#include "html/command_line.h"
#include "html/contents.h"
#include "html/page.h"
#include "options/option_use.h"
#include "options/subcommand.h"
#include "shell/kept_inputs.h"
#include "shell/output_file.h"
#include "shell/words.h"

#include <fca/convert/domain.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

constexpr std::string_view kAllModels = "all";

/// What a conversion is asked for: "all" is no model of one.
WritingOptions one_model(const ReportArguments& arguments) {
  WritingOptions options = arguments;
  if (options.model == kAllModels) options.model.clear();
  return options;
}

std::optional<std::string> usage_error(const ReportArguments& arguments) {
  if (const std::optional<std::string> error = check(arguments.reading)) return error;
  if (arguments.inputs.size() > 1 && !arguments.reading.join)
    return "a page is about one calibration; parts of it go behind --with, cameras of one rig want --join";
  if (!arguments.model.empty() && arguments.model != kAllModels && find_model(arguments.model) == nullptr)
    return unknown_model(arguments.model) + "; --model all lays every model beside the others";
  if (const std::optional<std::string> error = option_without_file(arguments)) return error;
  return problem_with(one_model(arguments));
}

/// As `convert` would, in memory.
ConvertOutcome converted(const ReportArguments& arguments, Console& console) {
  ConvertArguments convert;
  static_cast<WritingOptions&>(convert) = one_model(arguments);
  convert.inputs = arguments.inputs;
  convert.reading = arguments.reading;
  convert.dry_run = true;
  convert.json = true;  // which holds files that need a folder
  return convert_inputs(convert.inputs, convert, console);
}

/// The cameras as another model, for no format.
ConvertOutcome fitted(const ReportArguments& arguments, const ShownFile& shown) {
  ConvertOutcome outcome;
  outcome.input = shown.file;
  outcome.from = shown.calibration->format;
  outcome.diagnostics = shown.diagnostics;
  ConvertOptions options;
  options.model = arguments.model;
  options.max_angle_rad = max_angle_rad(arguments.reading);
  options.every_pixel = arguments.every_pixel;
  options.objective = arguments.objective == "max" ? Objective::kMax : Objective::kRms;
  options.reach = true;
  for (const Camera& camera : shown.calibration->rig.cameras) {
    std::optional<Conversion> conversion = convert(camera, options, outcome.diagnostics);
    if (!conversion) {
      outcome.code = worse(outcome.code, ExitCode::kBadInput);
      continue;
    }
    outcome.cameras.push_back({camera, std::move(conversion->camera), std::move(conversion->report)});
  }
  return outcome;
}

std::vector<CheckedFile> checked(const ReportArguments& arguments, const Calibration& calibration) {
  std::vector<CheckedFile> files;
  for (std::size_t i = 0; i < calibration.documents.size(); ++i) {
    CheckOptions options;
    options.reading = {parse_size(arguments.reading.size), arguments.reading.opencv_model, false};
    options.from = i < calibration.formats.size() ? calibration.formats[i] : nullptr;
    options.max_angle_rad = max_angle_rad(arguments.reading);
    options.parts = true;
    const text::Source& source = calibration.documents[i].source();
    files.push_back({source, check_file(source, options), {}});
  }
  return files;
}

/// All models of all cameras; nothing with errors where a camera is none.
std::optional<std::vector<std::vector<Candidate>>> all_candidates(const ReportArguments& arguments,
                                                                  const std::vector<Camera>& cameras,
                                                                  Diagnostics& diagnostics) {
  std::vector<std::vector<Candidate>> result;
  if (arguments.model != kAllModels) return result;
  const std::optional<double> limit = max_angle_rad(arguments.reading);
  // What no model could mend is said once, not once per model.
  for (const Camera& camera : cameras) {
    if (!domain_of(camera, limit, diagnostics)) return std::nullopt;
    result.push_back(candidates(camera, limit));
  }
  return result;
}

ExitCode put(const ReportArguments& arguments, const std::string& page, Console& console) {
  if (arguments.output.empty() || arguments.output == "-") {
    console.out(page);
    return ExitCode::kGood;
  }
  if (const std::optional<std::string> problem = KeptInputs(console, arguments.reading).problem_with(arguments.output))
    return console.refuse(ExitCode::kUsage, *problem);
  const OutputFile file{arguments.output, page};
  if (const std::optional<std::string> failure = write_files(std::span(&file, 1), arguments.force, false))
    return console.refuse(ExitCode::kIo, *failure);
  console.say("wrote " + arguments.output + "\n");
  return ExitCode::kGood;
}

ExitCode run_report(const ReportArguments& arguments, const CLI::App& command, Console& console) {
  if (const std::optional<std::string> error = usage_error(arguments)) return console.refuse(ExitCode::kUsage, *error);
  ReportContents contents;
  ShowArguments show;
  show.reading = arguments.reading;
  contents.shown = read_shown(arguments.inputs, show, console);
  if (!contents.shown.calibration)
    return console.refuse(worse(code_of(contents.shown.diagnostics), ExitCode::kBadInput), contents.shown.diagnostics);
  const Calibration& calibration = *contents.shown.calibration;
  if (!arguments.model.empty() && calibration.rig.cameras.empty())
    return console.refuse(ExitCode::kBadInput, contents.shown.file + " holds no camera");
  std::vector<std::string> names;
  for (const std::string& input : arguments.inputs)
    names.push_back(input == "-" ? "standard input" : std::filesystem::path(input).filename().string());
  contents.title = enumerated(names, "and");
  contents.max_angle_rad = max_angle_rad(arguments.reading);
  if (!arguments.to.empty() || !arguments.into.empty()) {
    contents.conversion = converted(arguments, console);
    contents.to = contents.conversion->to;
  } else if (!arguments.model.empty() && arguments.model != kAllModels) {
    contents.conversion = fitted(arguments, contents.shown);
  }
  // A conversion that is judged bad is what a page is for; one that cannot be made leaves nothing to show.
  if (contents.conversion && contents.conversion->code > ExitCode::kJudgedBad)
    return console.refuse(contents.conversion->code, contents.conversion->diagnostics);
  auto models = all_candidates(arguments, calibration.rig.cameras, contents.shown.diagnostics);
  if (!models) return console.refuse(ExitCode::kBadInput, contents.shown.diagnostics);
  contents.candidates = *std::move(models);
  contents.checks = checked(arguments, calibration);
  contents.command = command_line(command, "report", [](const std::string&) { return true; });
  if (contents.to != nullptr) {
    const bool all = arguments.model == kAllModels;
    contents.convert = command_line(command, "convert",
                                    [all](const std::string& name) {
                                      return name != "--output" && name != "--force" && !(all && name == "--model");
                                    }) +
                       " -o converted/";
  }
  console.show(contents.conversion ? contents.conversion->diagnostics : contents.shown.diagnostics);
  return put(arguments, report_page(contents), console);
}

void add_options(CLI::App& command, ReportArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command.add_option("INPUT", arguments.inputs, "Calibration file(s); '-' is standard input")->required();
  command.add_option("--to", arguments.to, "Show what converting it to this format does")->type_name("FORMAT");
  command
      .add_option("--model", arguments.model,
                  "Show what converting the cameras to this model does; all: every model beside the others, and which to take")
      ->type_name("MODEL|all");
  command.add_option("-o,--output", arguments.output, "The page: one HTML file (default: standard output)")->type_name("PATH");
  add_reading_options(command, arguments.reading);
  add_lens_circle_option(command, arguments.reading);
  add_join_option(command, arguments.reading);
  add_imu_option(command, arguments.reading);
  add_writing_options(command, arguments);
  command.add_flag("--force", arguments.force, "Overwrite an existing page");
  command.footer(
      "The page needs nothing beside itself: no network, no scripts. It is written even where convert would refuse to write\n"
      "the file (exit 1), and says so; of what cannot be converted at all (exit 2) there is none.\n\n"
      "Example:\n"
      "  fca-io report camchain.yaml --with imu.yaml --to orbslam3 --model eucm --max-angle 97.5 -o page.html\n"
      "  fca-io report camchain.yaml --model all -o models.html\n");
  command.callback([&arguments, &command, &run] {
    run = [&arguments, &command](Console& console) { return run_report(arguments, command, console); };
  });
}

}  // namespace

void add_report_command(CLI::App& app, ReportArguments& arguments, std::function<ExitCode(Console&)>& run) {
  add_subcommand(app, "report",
                 "A page to look at: what a file says, the rig drawn, and what converting it costs, as curves and error maps",
                 [&arguments, &run](CLI::App& command) { add_options(command, arguments, run); });
}

}  // namespace fca::cli
