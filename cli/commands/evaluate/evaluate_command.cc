// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_command.h"

#include "options/subcommand.h"
#include "recovered_images.h"

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

ExitCode run_evaluation(const EvaluateArguments& arguments, Console& console) {
  Diagnostics diagnostics;
  std::optional<Evaluation> evaluation = evaluate(diagnostics);
  // The cameras are ours, not the user's.
  if (!evaluation) return console.refuse(ExitCode::kBug, diagnostics);
  if (!arguments.image.empty() && !add_recovered_images(arguments.image, *evaluation, diagnostics))
    return console.refuse(worse(code_of(diagnostics), ExitCode::kBadInput), diagnostics);
  console.show(diagnostics);
  if (arguments.json) {
    console.out(evaluate_json(*evaluation));
  } else {
    console.say(evaluate_text(*evaluation));
  }
  return ExitCode::kGood;
}

void add_options(CLI::App& command, EvaluateArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command
      .add_option("--image", arguments.image,
                  "An image of 752 x 480 px: recovered by every row's conversion and compared with itself, PSNR and SSIM")
      ->type_name("IMAGE");
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.footer(
      "The cameras are the paper's. Its figures stand beside ours, and why they differ. The paper's images are not ours:\n"
      "--image takes any; examples/cpp/render_image.cc makes one.\n\n"
      "Example:\n"
      "  fca-io evaluate\n"
      "  fca-io evaluate --json > tables.json\n"
      "  fca-io evaluate --image seen.pgm\n");
  command.callback([&arguments, &run] { run = [&arguments](Console& console) { return run_evaluation(arguments, console); }; });
}

}  // namespace

void add_evaluate_command(CLI::App& app, EvaluateArguments& arguments, std::function<ExitCode(Console&)>& run) {
  add_subcommand(app, "evaluate",
                 "Tables 1-3 of Lee, Fisheye-Calib-Adapter (2024), recomputed on its cameras and judged on every pixel",
                 [&arguments, &run](CLI::App& command) { add_options(command, arguments, run); });
}

}  // namespace fca::cli
