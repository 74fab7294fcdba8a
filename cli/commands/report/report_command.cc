// SPDX-License-Identifier: BSD-3-Clause
#include "report_command.h"

#include "html/contents.h"
#include "html/page.h"
#include "options/command_line.h"
#include "options/inputs.h"
#include "options/output.h"
#include "options/target.h"
#include "options/words.h"
#include "shell/kept_inputs.h"
#include "shell/option_hints.h"
#include "shell/put_files.h"
#include "shell/verdict_text.h"
#include "shell/words.h"
#include "shell/written_names.h"

#include <fca/formats/text/message.h>
#include <fca/toolkit/report.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace fca::cli {

namespace {

constexpr std::string_view kAllModels = "all";

struct ReportArguments {
  ReportRequest request;
  std::string output;
  bool force = false;
};

std::optional<std::string> usage_error(const ReportArguments& arguments) {
  const ConvertRequest& conversion = arguments.request.conversion;
  if (const std::optional<std::string> error = problem_with(conversion.inputs)) return error;
  if (conversion.inputs.files.size() > 1 && !conversion.inputs.join)
    return "a page is about one calibration; parts of it go behind --with, cameras of one rig want --join";
  if (const std::optional<std::string> error = target_without_file(conversion)) return error;
  return problem_with(conversion);
}

/// The names of the files, without their folders.
std::string title_of(const Inputs& inputs) {
  std::vector<std::string> names;
  for (const std::string& file : inputs.files)
    names.push_back(file == "-" ? "standard input" : std::filesystem::path(file).filename().string());
  return enumerated(names, "and");
}

/// `convert` with the options of the page.
std::string convert_line(const ReportArguments& arguments, const TypedOptions& typed) {
  const auto keep = [&arguments](const TypedOption& option) {
    return !option.about_output && !(arguments.request.every_model && option.name == "--model");
  };
  return "fca-io " + command_line(typed, "convert", keep) + " -o converted/";
}

ExitCode put(const ReportArguments& arguments, const std::string& page, Console& console) {
  if (arguments.output.empty() || arguments.output == "-") {
    console.out(page);
    return ExitCode::kGood;
  }
  if (const std::optional<std::string> problem =
          KeptInputs(console, arguments.request.conversion.inputs).problem_with(arguments.output))
    return console.refuse(ExitCode::kUsage, *problem);
  const OutputFile file{arguments.output, page};
  if (const std::optional<Message> failure = put_files(std::span(&file, 1), arguments.force, console))
    return console.refuse(ExitCode::kIo, text::text_of(*failure, with_options));
  console.say("wrote " + arguments.output + "\n");
  return ExitCode::kGood;
}

ExitCode run_report(const ReportArguments& arguments, const TypedOptions& typed, Console& console) {
  if (const std::optional<std::string> error = usage_error(arguments)) return console.refuse(ExitCode::kUsage, *error);
  ReportRequest request = arguments.request;
  request.conversion.in_detail = true;
  ReportResult result = report(request, console.files());
  if (result.status > Status::kRejected) return console.refuse(exit_code(result.status), result.diagnostics());
  if (result.conversion) {
    name_as_written(*result.conversion);
    name_as_written(result.verdict, result.conversion->cameras);
  }
  const Inputs& inputs = arguments.request.conversion.inputs;
  ReportContents contents;
  contents.title = title_of(inputs);
  contents.shown = as_shown(std::move(result.reading), inputs);
  contents.checks = std::move(result.checks);
  contents.conversion = std::move(result.conversion);
  contents.to = contents.conversion ? contents.conversion->to : nullptr;
  contents.models = std::move(result.models);
  contents.verdict = std::move(result.verdict);
  contents.max_angle_rad = inputs.max_angle_rad;
  contents.command = "fca-io " + command_line(typed, "report", [](const TypedOption&) { return true; });
  if (contents.to != nullptr) contents.convert = convert_line(arguments, typed);
  const ExitCode code = put(arguments, report_page(contents), console);
  const bool on_page = !arguments.output.empty() && arguments.output != "-";
  if (on_page && code == ExitCode::kGood) {
    const std::string what = contents.to != nullptr ? "what convert would write" : "the file";
    console.say(
        wrapped_line(what + ": " + std::string(in_words(contents.verdict.word))) + summary_text(lines_of(contents.verdict)),
        contents.verdict.word);
  }
  console.show(contents.conversion ? contents.conversion->diagnostics : contents.shown.diagnostics);
  return contents.verdict.word == VerdictWord::kDoNotUse ? worse(code, ExitCode::kJudgedBad) : code;
}

void add_options(Options& options, ReportArguments& arguments) {
  ReportRequest& request = arguments.request;
  ConvertRequest& conversion = request.conversion;
  options.positional("INPUT", "Calibration file(s); '-' is standard input", conversion.inputs.files);
  add_to_option(options, "Show what converting it to this format does", conversion);
  const ModelOption model = {.values = "MODEL|all",
                             .help = "Show what converting the cameras to this model does",
                             .more = "; all: every model beside the others, and which to take"};
  add_model_option(options, model, [&request](const std::string& word) -> std::optional<std::string> {
    request.every_model = word == kAllModels;
    if (request.every_model) return std::nullopt;
    std::optional<std::string> problem = take_model(word, request.conversion.model);
    if (problem) *problem += "; --model all lays every model beside the others";
    return problem;
  });
  add_output_option(options, "The page: one HTML file (default: standard output)", arguments.output);
  add_input_options(options, conversion.inputs);
  add_lens_circle_option(options, conversion.inputs);
  add_join_option(options, conversion.inputs);
  add_imu_option(options, conversion.inputs);
  add_target_options(options, conversion);
  options.group(OptionGroup::kOutput);
  add_force_option(options, "Overwrite an existing page", arguments.force);
  options.footer(
      "The page needs nothing beside itself: no network, no scripts. It is written even where convert would refuse to write\n"
      "the file (exit 1), and says so; of what cannot be converted at all (exit 2) there is none.\n\n"
      "Example:\n"
      "  fca-io report camchain.yaml --with imu.yaml --to orbslam3 -o page.html\n"
      "  fca-io report camchain.yaml --model all -o models.html\n");
}

}  // namespace

void add_report_command(Application& application) {
  application.add(
      "report", "A page to look at: what a file says, the rig drawn, and what converting it costs, as curves and error maps",
      [](Options& options) -> RunCommand {
        const auto arguments = std::make_shared<ReportArguments>();
        add_options(options, *arguments);
        return [arguments](const TypedOptions& typed, Console& console) { return run_report(*arguments, typed, console); };
      });
}

}  // namespace fca::cli
