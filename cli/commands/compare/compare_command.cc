// SPDX-License-Identifier: BSD-3-Clause
#include "compare_command.h"

#include "html/comparison.h"
#include "options/command_line.h"
#include "options/inputs.h"
#include "options/limits.h"
#include "options/output.h"
#include "shell/kept_inputs.h"
#include "shell/option_hints.h"
#include "shell/put_files.h"
#include "shell/words.h"

#include <fca/formats/text/message.h>

#include <algorithm>
#include <memory>
#include <span>

namespace fca::cli {

namespace {

std::optional<std::string> usage_error(const CompareArguments& arguments) {
  const CompareRequest& request = arguments.request;
  if (const std::optional<std::string> error = problem_with(request.reference)) return error;
  if (request.reference.join) return "compare lays each FILE beside REF by itself: --join has no use here";
  if (!arguments.page.empty() && request.files.size() > 1) return "--report is about one FILE beside REF";
  if (arguments.force && arguments.page.empty()) return "--force is for --report: it overwrites an existing page";
  const std::ptrdiff_t from_stdin = std::ranges::count(request.files, "-") + std::ranges::count(request.reference.files, "-");
  if (from_stdin > 1) return "standard input can be read only once";
  return std::nullopt;
}

/// --report. Nothing is written of files that could not be compared.
ExitCode write_page(const CompareArguments& arguments, const TypedOptions& typed, const ReferenceFile& reference,
                    const ComparedFile& compared, const Console& console) {
  if (arguments.page.empty() || !compared.comparison || compared.comparison->cameras.empty()) return ExitCode::kGood;
  if (const std::optional<std::string> problem =
          KeptInputs(console, arguments.request.reference).problem_with(arguments.page)) {
    console.error(*problem);
    return ExitCode::kUsage;
  }
  const std::string line = "fca-io " + command_line(typed, "compare", [](const TypedOption&) { return true; });
  const OutputFile file{arguments.page, comparison_page(reference, compared, arguments.request.reference.max_angle_rad, line)};
  if (const std::optional<Message> failure = put_files(std::span(&file, 1), arguments.force, console)) {
    console.error(text::text_of(*failure, with_options));
    return ExitCode::kIo;
  }
  arguments.json ? console.say_aside("wrote " + file.path + "\n") : console.say("wrote " + file.path + "\n");
  return ExitCode::kGood;
}

ExitCode run_compare(const CompareArguments& arguments, const TypedOptions& typed, Console& console) {
  if (const std::optional<std::string> error = usage_error(arguments)) return console.refuse(ExitCode::kUsage, *error);
  const CompareRequest& request = arguments.request;
  const ReferenceFile reference = read_reference(request, console.files());
  ExitCode code = exit_code(status_of(reference.diagnostics));
  // Nothing can be compared with it.
  if (!reference.calibration) return console.refuse(worse(code, ExitCode::kBadInput), reference.diagnostics);
  if (!arguments.json) console.show(reference.diagnostics);
  std::vector<ComparedFile> files;
  for (const std::string& file : request.files) {
    files.push_back(compare(request, reference, file, console.files()));
    const ComparedFile& compared = files.back();
    code = worse(code, exit_code(compared.status));
    if (!arguments.json) {
      const bool some = compared.comparison && (compared.status <= Status::kRejected || !compared.comparison->cameras.empty());
      if (some) console.say((files.size() > 1 ? "\n" : "") + compare_text(reference, compared, arguments.verbose));
      console.show(compared.diagnostics);
      if (!some) console.say_aside("verdict: " + file + ": " + verdict_of(compared) + "\n");
    }
    code = worse(code, write_page(arguments, typed, reference, compared, console));
  }
  if (arguments.json) console.out(compare_json(reference, files, console));
  return code;
}

void add_options(Options& options, CompareArguments& arguments) {
  CompareRequest& request = arguments.request;
  options.positional("REF", "The calibration that counts as right; '-' is standard input", arguments.reference);
  options.positional("FILE", "Calibration file(s) to lay beside it, each by itself", request.files);
  add_input_options(options, request.reference);
  add_lens_circle_option(options, request.reference);
  add_join_option(options, request.reference);
  options.hide({"--join"});  // refused: not worth a line of the help
  options.each("--with-file", "FILE", "A further part of FILE, as --with is one of REF; may be given several times",
               request.parts);
  options.group(OptionGroup::kProof);
  add_max_error_option(
      options,
      "Exit with 1 if a camera's worst pixel is off by more, if a camera or more than a thousandth of its image is "
      "missing, or if one of the mistakes that people make is found, in poses, IMU and times too",
      request.max_error_px);
  add_strict_option(
      options,
      "Exit with 1 also if poses are more than 0.5 deg, or 5 mm and 5 % of the distance, apart, time offsets more "
      "than 1 ms, other numbers more than 5 %, or if FILE does not say what REF says; --max-error is then 0.25 "
      "where it is not given",
      request.strict);
  add_every_pixel_option(options, request.every_pixel);
  options.group(OptionGroup::kOutput);
  options.value("--report", "PATH",
                "Also write a page to look at (one HTML file): differences over the image and the angle, both rigs drawn",
                arguments.page);
  add_force_option(options, "With --report: overwrite an existing page", arguments.force);
  add_verbose_option(options, "Also the errors over the angle from the axis, as a table", arguments.verbose);
  add_json_option(options, arguments.json);
  options.footer(
      "Errors are measured as convert measures them: a pixel of REF's image, its ray by REF, the pixel of that ray by FILE. "
      "Cameras\n"
      "are matched by name, else by order; with --camera by the order given there. --with, --crop, --binning and --resize are\n"
      "REF's. Images of another size and the same proportions are scaled.\n\n"
      "Exit codes: 0 compared, whatever the differences; 1 --max-error or --strict not met; 2 bad input; 3 usage; 4 "
      "input/output.\n\n"
      "Example:\n"
      "  fca-io compare camchain.yaml --with imu.yaml settings.yaml --report page.html\n"
      "  fca-io compare before.yaml after.yaml --max-angle 97.5 --max-error 0.5\n");
}

}  // namespace

void add_compare_command(Application& application) {
  application.add(
      "compare",
      "How calibrations of any formats and models differ: pixels, degrees, poses, IMU, time; and which mistake it is",
      [](Options& options) -> RunCommand {
        const auto arguments = std::make_shared<CompareArguments>();
        add_options(options, *arguments);
        return [arguments](const TypedOptions& typed, Console& console) {
          arguments->request.reference.files = {arguments->reference};
          return run_compare(*arguments, typed, console);
        };
      });
}

}  // namespace fca::cli
