// SPDX-License-Identifier: BSD-3-Clause
#include "convert.h"

#include "inputs.h"
#include "limits.h"
#include "output.h"
#include "target.h"
#include "words.h"

#include <fca/formats/text/prose.h>

#include <filesystem>
#include <string_view>

namespace fca::cli {

namespace {

/// A name of each format whose program takes cameras on its command line.
std::vector<std::string> printed(std::string_view Format::*name) {
  std::vector<std::string> names;
  for (const Format& format : written_formats()) {
    if (format.arguments != nullptr) names.emplace_back(format.*name);
  }
  return names;
}

/// What follows from several words.
std::optional<std::string> finish(ConvertArguments& arguments) {
  arguments.json = arguments.json || arguments.json_lines;
  arguments.request.in_detail = arguments.json || arguments.verbosity > 0;
  arguments.request.errors_of_kept = arguments.request.in_detail;
  const std::string extension = std::filesystem::path(arguments.output.path).extension().string();
  if (!extension.empty()) arguments.request.extension = extension;
  return std::nullopt;
}

}  // namespace

void add_convert_options(Options& options, ConvertArguments& arguments) {
  ConvertRequest& request = arguments.request;
  options.positional("INPUT", "Calibration file(s), folders or patterns ('rigs/*.yaml'); '-' is standard input",
                     arguments.inputs);
  add_to_option(options, "The format to write", request);
  add_model_option(
      options, {.help = "The camera model to write", .more = " (default: kept, else the best that the stock program reads)"},
      [&request](const std::string& word) { return take_model(word, request.model); });
  add_output_option(options,
                    "A path, a folder, or a pattern with {stem}, {extension}, {folder}, {camera}, {format} (a slash at the "
                    "end: one folder for each; default: standard output)",
                    arguments.output);
  add_input_options(options, request.inputs);
  add_lens_circle_option(options, request.inputs);
  add_join_option(options, request.inputs);
  add_imu_option(options, request.inputs);
  add_target_options(options, request);
  options.flag("--in-place", "With --into: change BASE itself", arguments.in_place);
  options.flag("--print",
               "Print the cameras as arguments of the program's command line (" +
                   text::enumerated(printed(&Format::program), "or") + "), write no file",
               arguments.request.as_arguments);
  options.group(OptionGroup::kOutput);
  options.exclusive_flags(
      {{"--provenance", "Write the comment about the file's origin into an edited file, too (fresh files always get it)",
        [&request] { request.provenance = ProvenanceComment::kInAllFiles; }},
       {"--no-provenance", "Leave out that comment", [&request] { request.provenance = ProvenanceComment::kNone; }}},
      "--provenance and --no-provenance contradict each other");
  options.group(OptionGroup::kProof);
  add_max_error_option(
      options,
      "Fail (exit 1, nothing written) if the largest error is above this, at or between pixels; or if a part of "
      "the image (with --max-angle or --lens-circle: of the lens) has no pixel in the new model: more than "
      "0.1 % of it, or a part that the fit had to give up. With a covariance of the parameters, the limit may "
      "also be in standard deviations of the calibration's own pixels: '0.2sigma'",
      request.max_error_px, request.max_error_sigmas);
  add_strict_option(options, "Fail if the output cannot hold something of the input that the target's program uses",
                    request.strict);
  options.flag_pair("--verify", "Test the output with fca-io's copy of the program's reader before saving it (the default)",
                    "--no-verify", "Skip that test", request.verify);
  add_accept_option(options, request.accepted);
  options.group(OptionGroup::kOutput);
  add_jobs_option(options, "Inputs, or cameras of one input, converted at the same time", request.jobs);
  options.flag("--dry-run", "Print the report, write nothing", arguments.dry_run);
  add_force_option(options, "Replace existing files; their other hard links keep the old text", arguments.force);
  options.flag("--fsync", "Force the files to disk before they replace old ones (all of a batch at once)", arguments.fsync);
  add_json_option(options, arguments.json);
  add_json_lines_option(options, arguments.json_lines);
  add_verbose_option(options, "The full report; -vv: also the parameters, as a table", arguments.verbosity);
  add_quiet_option(options, "Errors only", arguments.quiet);
  options.footer(
      "Example:\n"
      "  fca-io convert camchain.yaml --with imu.yaml --to orbslam3 -o settings.yaml\n"
      "  fca-io convert camchain.yaml --to kalibr --model eucm --max-angle 97.5 -o out/\n");
  options.afterwards([&arguments] { return finish(arguments); });
}

std::optional<std::string> problem_with(const ConvertArguments& arguments, bool many) {
  const ConvertRequest& request = arguments.request;
  if (arguments.in_place && request.into.empty()) {
    const std::string input = text::shell_word(arguments.inputs.front());
    return "--in-place is for --into BASE; to change the input itself: fca-io convert " + input + " --into " + input +
           " --in-place";
  }
  if (request.into.empty() && request.to == nullptr) return "--to FORMAT is missing: " + target_names();
  if (const std::optional<std::string> error = problem_with(request)) return error;
  if (arguments.in_place && arguments.output.is_said()) return "--in-place writes BASE itself; leave out -o";
  if (request.as_arguments && (request.to == nullptr || request.to->arguments == nullptr)) {
    return "--print is for programs that take a camera on their command line: --to " +
           text::enumerated(printed(&Format::id), "or");
  }
  if (request.as_arguments && (arguments.output.is_said() || !request.into.empty()))
    return "--print writes no file: leave out -o and --into";
  if (many && !request.into.empty()) return "--into takes one input, or several that are one rig (--join)";
  constexpr std::string_view kOneRig = "; give parts of one calibration after --with, and cameras of one rig with --join";
  if (many && arguments.output.is_said() && !arguments.output.holds_many())
    return "several inputs need -o FOLDER/ or a pattern such as -o 'out/{stem}.{format}.yaml'" + std::string(kOneRig);
  if (many && !arguments.output.is_said() && !arguments.json)
    return "several inputs need -o FOLDER/ (or --json)" + std::string(kOneRig);
  return problem_with_pattern(arguments.output);
}

}  // namespace fca::cli
