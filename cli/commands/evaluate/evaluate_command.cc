// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_command.h"

#include "options/evaluate.h"

namespace fca::cli {

namespace {

ExitCode run_evaluation(const EvaluateArguments& arguments, Console& console) {
  const EvaluateResult result = evaluate({arguments.image}, console.files());
  if (result.status != Status::kDone) return console.refuse(exit_code(result.status), result.diagnostics);
  console.show(result.diagnostics);
  if (arguments.json) {
    console.out(evaluate_json(result));
  } else {
    console.say(evaluate_text(result));
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
