// SPDX-License-Identifier: BSD-3-Clause
#include "convert_command.h"

#include "batch.h"
#include "options/inputs.h"
#include "options/limits.h"
#include "options/output.h"
#include "options/target.h"
#include "options/words.h"
#include "shell/calibration_files.h"
#include "shell/output_name.h"
#include "shell/words.h"
#include "shell/written_outputs.h"

#include <fca/code.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

std::optional<std::string> usage_error(const ConvertArguments& arguments, const std::vector<FoundFile>& files) {
  const ConvertRequest& request = arguments.request;
  if (const std::optional<std::string> error = problem_with(request.inputs)) return error;
  if (arguments.in_place && request.into.empty()) {
    const std::string input = shell_word(arguments.inputs.front());
    return "--in-place is for --into BASE; to change the input itself: fca-io convert " + input + " --into " + input +
           " --in-place";
  }
  if (request.into.empty() && request.to == nullptr) return "--to FORMAT is missing: " + format_names();
  if (const std::optional<std::string> error = problem_with(request)) return error;
  if (arguments.in_place && arguments.output.is_said()) return "--in-place writes BASE itself; leave out -o";
  if (arguments.print && (request.to == nullptr || request.to->arguments == nullptr))
    return "--print is for programs that take a camera on their command line: --to colmap";
  if (arguments.print && (arguments.output.is_said() || !request.into.empty()))
    return "--print writes no file: leave out -o and --into";
  const bool many = !request.inputs.join && (files.size() > 1 || (files.size() == 1 && !files.front().named));
  if (many && !request.into.empty()) return "--into wants one input, or several that are one rig (--join)";
  constexpr std::string_view kOneRig = "; parts of one calibration go behind --with, cameras of one rig want --join";
  if (many && arguments.output.is_said() && !arguments.output.holds_many())
    return "several inputs need -o FOLDER/ or a pattern such as -o 'out/{stem}.{format}.yaml'" + std::string(kOneRig);
  if (many && !arguments.output.is_said() && !arguments.json)
    return "several inputs need -o FOLDER/ (or --json)" + std::string(kOneRig);
  return problem_with_pattern(arguments.output);
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

/// `convert camchain.yaml imu.yaml`: of a few inputs the one with cameras is the calibration, the others are parts of it.
ConvertArguments with_parts(const ConvertArguments& arguments, const std::vector<FoundFile>& files, Streams& streams) {
  if (!std::ranges::all_of(files, [](const FoundFile& file) { return file.named && is_at_hand(file); })) return arguments;
  Inputs inputs = arguments.request.inputs;
  inputs.files.clear();
  for (const FoundFile& file : files) inputs.files.push_back(file.path);
  CommandFiles read_apart(streams);
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
  const ConvertArguments arguments = into_cameras(with_parts(given, walk_rigs(given.inputs), console.streams()));
  const std::vector<FoundFile> files = walk_rigs(arguments.inputs);
  if (const std::optional<std::string> error = usage_error(arguments, files)) return console.refuse(ExitCode::kUsage, *error);
  const HeldInterrupt interrupt(files.size() > 1 && std::ranges::all_of(files, is_at_hand), console);
  Batch batch = convert_batch(files, arguments, typed, interrupt, console);
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

void add_options(Options& options, ConvertArguments& arguments) {
  ConvertRequest& request = arguments.request;
  options.positional("INPUT", "Calibration file(s), folders or patterns ('rigs/*.yaml'); '-' is standard input",
                     arguments.inputs);
  add_to_option(options, "The format to write", request);
  add_model_option(
      options, {.help = "The camera model to write", .more = " (default: kept, else the best that the stock program reads)"},
      [&request](const std::string& word) { return take_model(word, request.model); });
  add_output_option(
      options,
      "A path, a folder, or a pattern with {stem}, {extension}, {folder}, {camera}, {format} (ends with a slash: a folder "
      "for each; default: standard output)",
      arguments.output);
  add_input_options(options, request.inputs);
  add_lens_circle_option(options, request.inputs);
  add_join_option(options, request.inputs);
  add_imu_option(options, request.inputs);
  add_target_options(options, request);
  options.flag("--in-place", "With --into: change BASE itself", arguments.in_place);
  options.flag("--print", "Print the cameras as arguments of the program's command line (COLMAP), write no file",
               arguments.print);
  options.group(OptionGroup::kOutput);
  options.exclusive_flags(
      {{"--provenance", "Say in a comment where the file comes from even in an edited file (fresh ones say it anyway)",
        [&request] { request.provenance = ProvenanceComment::kInAllFiles; }},
       {"--no-provenance", "Leave out that comment", [&request] { request.provenance = ProvenanceComment::kNone; }}},
      "--provenance and --no-provenance contradict each other");
  options.group(OptionGroup::kProof);
  add_max_error_option(
      options,
      "Fail (exit 1, nothing written) if the largest error of what was scored is more (the max of the report: "
      "polished to where it really is, between the pixels, too), or if a part of the image (of the lens, if "
      "--max-angle or --lens-circle says where it ends), more than a thousandth of it or what the fit had to give "
      "up, has no pixel in the new model",
      request.max_error_px);
  add_strict_option(options, "Fail if a fact of the input that the target's program uses cannot be carried", request.strict);
  options.flag_pair(
      "--verify",
      "Try the written bytes with our re-implementation of the program's reader before they are put in place (the default)",
      "--no-verify", "Do not try it", request.verify);
  add_accept_option(options, request.accepted);
  options.group(OptionGroup::kOutput);
  add_jobs_option(options, "Inputs, or cameras of one, worked on at the same time", request.jobs);
  options.flag("--dry-run", "Report, write nothing", arguments.dry_run);
  add_force_option(options, "Replace existing files; their other hard links keep the old text", arguments.force);
  options.flag("--fsync", "Force the files to disk before they replace old ones (all of a batch at once)", arguments.fsync);
  add_json_option(options, arguments.json);
  add_verbose_option(options, "The full report; -vv: and the parameters, as a table", arguments.verbosity);
  options.flag("-q,--quiet", "Errors only", arguments.quiet);
  options.footer(
      "Example:\n"
      "  fca-io convert camchain.yaml --with imu.yaml --to orbslam3 -o settings.yaml\n"
      "  fca-io convert camchain.yaml --to kalibr --model eucm --max-angle 97.5 -o out/\n");
}

}  // namespace

void add_convert_command(Application& application) {
  application.add("convert", "Convert a calibration to another format, and to another camera model if need be",
                  [](Options& options) -> RunCommand {
                    const auto arguments = std::make_shared<ConvertArguments>();
                    add_options(options, *arguments);
                    return [arguments](const TypedOptions& typed, Console& console) {
                      arguments->request.in_detail = arguments->json || arguments->verbosity > 0;
                      const std::string extension = std::filesystem::path(arguments->output.path).extension().string();
                      if (!extension.empty()) arguments->request.extension = extension;
                      return run_convert(*arguments, typed, console);
                    };
                  });
}

}  // namespace fca::cli
