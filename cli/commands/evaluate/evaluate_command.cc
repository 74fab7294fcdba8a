// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_command.h"
#include "options/output.h"

#include <memory>

namespace fca::cli {

namespace {

struct EvaluateArguments {
  std::string image;  ///< A path; empty: tables without images.
  bool json = false;
};

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

void add_options(Options& options, EvaluateArguments& arguments) {
  options.value("--image", "IMAGE",
                "An image of 752 x 480 px: recovered by every row's conversion and compared with itself, PSNR and SSIM",
                arguments.image);
  add_json_option(options, arguments.json);
  options.footer(
      "The cameras are the paper's. Its figures stand beside ours, and why they differ. The paper's images are not ours:\n"
      "--image takes any; examples/cpp/render_image.cc makes one.\n\n"
      "Example:\n"
      "  fca-io evaluate\n"
      "  fca-io evaluate --json > tables.json\n"
      "  fca-io evaluate --image seen.pgm\n");
}

}  // namespace

void add_evaluate_command(Application& application) {
  application.add("evaluate",
                  "Tables 1-3 of Lee, Fisheye-Calib-Adapter (2024), recomputed on its cameras and evaluated at every pixel",
                  [](Options& options) -> RunCommand {
                    const auto arguments = std::make_shared<EvaluateArguments>();
                    add_options(options, *arguments);
                    return [arguments](const TypedOptions&, Console& console) { return run_evaluation(*arguments, console); };
                  });
}

}  // namespace fca::cli
