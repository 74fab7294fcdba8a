// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_command.h"

#include "options/evaluate.h"

namespace fca::cli {

namespace {

ExitCode run_evaluation(const EvaluateArguments& arguments, Console& console) {
  Diagnostics diagnostics;
  std::optional<Evaluation> evaluation = evaluate(diagnostics);
  // The cameras are ours, not the user's.
  if (!evaluation) return console.refuse(ExitCode::kBug, diagnostics);
  if (!arguments.image.empty() && !add_recovered_images(arguments.image, *evaluation, console.files(), diagnostics))
    return console.refuse(worse(exit_code(status_of(diagnostics)), ExitCode::kBadInput), diagnostics);
  console.show(diagnostics);
  if (arguments.json) {
    console.out(evaluate_json(*evaluation));
  } else {
    console.say(evaluate_text(*evaluation));
  }
  return ExitCode::kGood;
}

}  // namespace

void add_evaluate_command(Application& application) {
  application.add<EvaluateArguments>(
      "evaluate", "Tables 1-3 of Lee, Fisheye-Calib-Adapter (2024), recomputed on its cameras and evaluated at every pixel",
      &add_evaluate_options, &run_evaluation);
}

}  // namespace fca::cli
