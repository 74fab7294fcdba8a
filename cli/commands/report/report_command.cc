// SPDX-License-Identifier: BSD-3-Clause
#include "report_command.h"

#include "html/contents.h"
#include "html/page.h"
#include "options/command_line.h"
#include "options/report.h"
#include "shell/kept_inputs.h"
#include "shell/option_hints.h"
#include "shell/put_files.h"
#include "shell/verdict_text.h"
#include "shell/words.h"
#include "shell/written_names.h"

#include <fca/formats/text/message.h>
#include <fca/toolkit/report.h>

#include <optional>
#include <span>
#include <string_view>

namespace fca::cli {

namespace {

/// The names of the files, without their folders.
std::string title_of(const Inputs& inputs) {
  std::vector<std::string> names;
  for (const std::string& file : inputs.files) names.push_back(file_in_words(file));
  return enumerated(names, "and");
}

/// `convert` with the options of the page.
std::string convert_line(const ReportArguments& arguments, const TypedOptions& typed) {
  const auto keep = [&arguments](const TypedOption& option) {
    return !option.about_output && !(arguments.request.every_model && option.key == OptionKey::kModel);
  };
  return "fca-io " + command_line(typed, "convert", keep) + " -o converted/";
}

ExitCode put(const ReportArguments& arguments, const std::string& page, Console& console) {
  const std::string& path = arguments.output.path;
  if (arguments.output.is_standard_output()) {
    console.out(page);
    return ExitCode::kGood;
  }
  KeptInputs inputs(console, arguments.request.conversion.inputs);
  inputs.add(std::span(&arguments.request.conversion.weight_image, 1));
  if (const std::optional<std::string> problem = inputs.problem_with(path)) return console.refuse(ExitCode::kUsage, *problem);
  const OutputFile file{path, page};
  if (const std::optional<Message> failure = put_files(std::span(&file, 1), arguments.force, console))
    return console.refuse(ExitCode::kIo, text::text_of(*failure, with_options));
  console.say("wrote " + path + "\n");
  return ExitCode::kGood;
}

ExitCode run_report(const ReportArguments& arguments, const TypedOptions& typed, Console& console) {
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
  if (!arguments.output.is_standard_output() && code == ExitCode::kGood) {
    const std::string what = contents.to != nullptr ? "what convert would write" : "the file";
    console.say(
        wrapped_line(what + ": " + std::string(in_words(contents.verdict.word))) + summary_text(lines_of(contents.verdict)),
        contents.verdict.word);
  }
  console.show(contents.conversion ? contents.conversion->diagnostics : contents.shown.diagnostics);
  return contents.verdict.word == VerdictWord::kDoNotUse ? worse(code, ExitCode::kRejected) : code;
}

}  // namespace

void add_report_command(Application& application) {
  application.add<ReportArguments>(
      "report",
      "A page to look at: what a file contains, the rig drawn, and what converting it costs, as curves and error maps",
      &add_report_options, &run_report);
}

}  // namespace fca::cli
