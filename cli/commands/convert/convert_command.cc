// SPDX-License-Identifier: BSD-3-Clause
#include "convert_command.h"

#include "batch.h"
#include "options/target.h"
#include "shell/calibration_files.h"
#include "shell/words.h"
#include "shell/written_outputs.h"

#include <fca/code.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <filesystem>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// Are they more than one conversion?
bool are_many(const ConvertArguments& arguments, const std::vector<FoundFile>& files) {
  return !arguments.request.inputs.join && (files.size() > 1 || (files.size() == 1 && !files.front().named));
}

/// Reading anything but files, and folders of them, may wait for ever.
bool is_at_hand(const FoundFile& file) {
  std::error_code ignored;
  return fs::is_regular_file(file.path, ignored) || fs::is_directory(file.path, ignored);
}

/// --opencv-model without a file that it could be about.
std::optional<std::string> opencv_model_problem(const ConvertArguments& arguments,
                                                const std::vector<ConvertOutcome>& outcomes) {
  const std::vector<ConvertResult> results(outcomes.begin(), outcomes.end());
  Inputs inputs = arguments.request.inputs;
  inputs.files = {outcomes.empty() ? "" : outcomes.front().input};
  return opencv_model_without_use(inputs, results);
}

/// What was accepted for nothing, of any input, is a mistake, or a leftover.
void warn_of_unused(const std::vector<Acceptance>& accepted, const std::vector<ConvertOutcome>& outcomes,
                    const Console& console) {
  for (const Acceptance& each : accepted) {
    const auto is_used = [&each](const ConvertOutcome& outcome) {
      return std::ranges::any_of(outcome.verdict.reasons, [&each](const Reason& reason) {
        return each.covers(reason) && (reason.is_accepted || !may_be_accepted(reason));
      });
    };
    const auto has_result = [](const ConvertOutcome& outcome) {
      return outcome.status <= Status::kRejected && outcome.code != ExitCode::kIo;
    };
    if (std::ranges::none_of(outcomes, has_result) || std::ranges::any_of(outcomes, is_used)) continue;
    console.err("warning: --accept " + std::string(info(each.code).id) + (each.camera.empty() ? "" : ":" + each.camera) +
                " was not needed\n");
  }
}

/// `convert camchain.yaml imu.yaml`: of a few inputs the one with cameras is the calibration, the others are parts of it. To
/// know, they are read.
ConvertArguments with_parts(const ConvertArguments& arguments, const std::vector<FoundFile>& files, Files& read_apart) {
  if (!std::ranges::all_of(files, [](const FoundFile& file) { return file.named && is_at_hand(file); })) return arguments;
  Inputs inputs = arguments.request.inputs;
  inputs.files.clear();
  for (const FoundFile& file : files) inputs.files.push_back(file.path);
  const Inputs recognised = with_parts_recognised(inputs, read_apart);
  if (recognised.files.size() == files.size()) return arguments;
  ConvertArguments result = arguments;
  result.inputs = recognised.files;
  result.request.inputs.parts = recognised.parts;
  return result;
}

/// The summary says those.
Diagnostics without_errors(const Diagnostics& diagnostics) {
  Diagnostics rest;
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity != Severity::kError) rest.add(entry);
  }
  return rest;
}

/// Of a model's folder that is to be written into the file of its cameras is changed.
ConvertArguments into_cameras(ConvertArguments arguments) {
  const std::vector<std::string> model = model_files_in(arguments.request.into);
  if (!model.empty()) arguments.request.into = model.front();
  return arguments;
}

ExitCode run_convert(const ConvertArguments& given, const TypedOptions& typed, Console& console) {
  if (const std::optional<std::string> problem = problem_with_patterns(given.inputs))
    return console.refuse(ExitCode::kIo, *problem);
  CommandFiles read_apart(console.streams());
  const ConvertArguments arguments = into_cameras(with_parts(given, walk_rigs(given.inputs), read_apart));
  const std::vector<FoundFile> files = walk_rigs(arguments.inputs);
  if (const std::optional<std::string> error = problem_with(arguments, are_many(arguments, files)))
    return console.refuse(ExitCode::kUsage, *error);
  const HeldInterrupt interrupt(files.size() > 1 && std::ranges::all_of(files, is_at_hand), console);
  Batch batch = convert_batch(files, arguments, typed, interrupt, read_apart, console);
  std::vector<ConvertOutcome>& outcomes = batch.outcomes;
  if (outcomes.empty() && batch.left == 0) {
    return console.refuse(ExitCode::kBadInput, "no calibration with a camera in " + enumerated(arguments.inputs) + " (" +
                                                   counted(batch.skipped, "file") + " looked at)");
  }
  if (const std::optional<std::string> error = opencv_model_problem(arguments, outcomes))
    return console.refuse(ExitCode::kUsage, *error);
  if (collide(outcomes, console)) return ExitCode::kUsage;

  ExitCode code = ExitCode::kGood;
  const bool in_full = is_told_in_full(outcomes.size() + batch.skipped + batch.left);
  const bool file_on_stdout = arguments.output.is_standard_output() && !arguments.in_place;
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
      const bool has_result = outcome.status <= Status::kRejected && outcome.code != ExitCode::kIo;
      // That a file is not to be used is an error, also for those who want to see errors only.
      const bool is_wanted = !arguments.quiet || outcome.code != ExitCode::kGood;
      const bool has_word = !outcome.files.empty() || outcome.verdict.word == VerdictWord::kDoNotUse;
      const bool has_summary = has_result && in_full && is_wanted && has_word;
      if (has_summary) {
        const bool written = !arguments.dry_run;
        std::string report = convert_summary(outcome, written, arguments.verbosity == 0);
        if (arguments.verbosity > 0) report += "\n" + convert_text(outcome, written, arguments.verbosity > 1);
        const VerdictWord word = outcome.verdict.word;
        (file_on_stdout && written) || arguments.quiet ? console.say_aside(report, word) : console.say(report, word);
      }
      if (in_full && !arguments.quiet && (arguments.verbosity > 0 || !has_result)) {
        console.show(has_summary ? without_errors(outcome.diagnostics) : outcome.diagnostics);
      } else if (!has_summary) {
        console.show_errors(outcome.diagnostics);
      }
    }
    code = worse(code, outcome.code);
  }
  if (!arguments.json) warn_of_unused(arguments.request.accepted, outcomes, console);
  if (arguments.json) console.out(convert_json(outcomes, console));
  const bool several = outcomes.size() > 1 || batch.skipped > 0 || batch.left > 0;
  if (several && !arguments.quiet) {
    const std::string text = batch_text(batch, !arguments.dry_run);
    arguments.json ? console.say_aside(text) : console.say(text);
  }
  return code;
}

}  // namespace

void add_convert_command(Application& application) {
  application.add<ConvertArguments>("convert",
                                    "Convert a calibration to another format, and to another camera model if need be",
                                    &add_convert_options, &run_convert);
}

}  // namespace fca::cli
