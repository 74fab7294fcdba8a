// SPDX-License-Identifier: BSD-3-Clause
#include "compare_command.h"

#include "html/comparison.h"
#include "options/command_line.h"
#include "shell/kept_inputs.h"
#include "shell/option_hints.h"
#include "shell/put_files.h"
#include "shell/words.h"

#include <fca/formats/text/message.h>

#include <span>

namespace fca::cli {

namespace {

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
  arguments.json ? console.print_stderr("wrote " + file.path + "\n") : console.say("wrote " + file.path + "\n");
  return ExitCode::kGood;
}

ExitCode run_compare(const CompareArguments& arguments, const TypedOptions& typed, Console& console) {
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
      if (!some) console.print_stderr("verdict: " + file + ": " + verdict_of(compared) + "\n");
    }
    code = worse(code, write_page(arguments, typed, reference, compared, console));
  }
  if (arguments.json) console.out(compare_json(reference, files, console));
  return code;
}

}  // namespace

void add_compare_command(Application& application) {
  application.add<CompareArguments>(
      "compare",
      "How calibrations of any formats and models differ: pixels, degrees, poses, IMU, time; and which mistake it is",
      &add_compare_options, &run_compare);
}

}  // namespace fca::cli
