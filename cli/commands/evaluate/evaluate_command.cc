// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_command.h"

#include "options/evaluate.h"
#include "shell/kept_inputs.h"
#include "shell/option_hints.h"
#include "shell/put_files.h"

#include <fca/formats/text/message.h>

#include <optional>
#include <span>

namespace fca::cli {

namespace {

/// Nothing where the page was put in its place, or none was asked for.
std::optional<ExitCode> put_page(const EvaluateArguments& arguments, const EvaluateResult& result, Console& console) {
  const std::string& path = arguments.page.path;
  if (path.empty()) return std::nullopt;
  KeptInputs kept{Inputs()};
  kept.add(std::span(&arguments.image, 1));
  if (const std::optional<std::string> problem = kept.problem_with(path)) return console.refuse(ExitCode::kUsage, *problem);
  const OutputFile file{path, evaluate_page(result)};
  if (const std::optional<Message> failure = put_files(std::span(&file, 1), arguments.force, console))
    return console.refuse(ExitCode::kIo, text::text_of(*failure, with_options));
  return std::nullopt;
}

ExitCode run_evaluation(const EvaluateArguments& arguments, Console& console) {
  const bool page_only = arguments.page.kind == OutputPlace::Kind::kStandardOutput;
  const EvaluateResult result = evaluate({arguments.image, page_only || !arguments.page.path.empty()}, console.files());
  if (result.status != Status::kDone) return console.refuse(exit_code(result.status), result.diagnostics);
  console.show(result.diagnostics);
  if (page_only) {
    console.out(evaluate_page(result));
    return ExitCode::kGood;
  }
  if (const std::optional<ExitCode> failed = put_page(arguments, result, console)) return *failed;
  if (arguments.json) {
    console.out(evaluate_json(result));
  } else {
    console.say(evaluate_text(result));
    if (!arguments.page.path.empty()) console.say("\nwrote " + arguments.page.path + "\n");
  }
  return ExitCode::kGood;
}

}  // namespace

void add_evaluate_command(Application& application) {
  application.add<EvaluateArguments>("evaluate",
                                     "Tables 1-3 and Figures 2 and 3 of Lee, Fisheye-Calib-Adapter (2024), recomputed on its "
                                     "cameras and evaluated at every pixel",
                                     &add_evaluate_options, &run_evaluation);
}

}  // namespace fca::cli
