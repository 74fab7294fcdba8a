// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include "inputs.h"
#include "output.h"
#include "target.h"
#include "words.h"

namespace fca::cli {

namespace {

/// A model, or all.
std::optional<std::string> take_models(const std::string& word, ReportRequest& request) {
  request.every_model = word == "all";
  if (request.every_model) return std::nullopt;
  std::optional<std::string> problem = take_model(word, request.conversion.model);
  if (problem) *problem += "; --model all compares every model with the others";
  return problem;
}

std::optional<std::string> usage_error(const ConvertRequest& conversion) {
  if (conversion.inputs.files.size() > 1 && !conversion.inputs.join)
    return "a page shows one calibration; give its parts after --with, and cameras of one rig with --join";
  if (const std::optional<std::string> error = target_without_file(conversion)) return error;
  return problem_with(conversion);
}

}  // namespace

void add_report_options(Options& options, ReportArguments& arguments) {
  ReportRequest& request = arguments.request;
  ConvertRequest& conversion = request.conversion;
  options.positional("INPUT", "Calibration file(s); '-' is standard input", conversion.inputs.files);
  add_to_option(options, "Show what converting it to this format does", conversion);
  const ModelOption model = {.values = "MODEL|all",
                             .help = "Show what converting the cameras to this model does",
                             .more = "; all: every model next to the others, and which to take"};
  add_model_option(options, model, [&request](const std::string& word) { return take_models(word, request); });
  add_output_option(options, "The page: one HTML file (default: standard output)", arguments.output);
  add_input_options(options, conversion.inputs);
  add_lens_circle_option(options, conversion.inputs);
  add_join_option(options, conversion.inputs);
  add_imu_option(options, conversion.inputs);
  add_target_options(options, conversion);
  options.group(OptionGroup::kOutput);
  add_force_option(options, "Overwrite an existing page", arguments.force);
  options.footer(
      "The page is one file, without scripts, and needs no network. report writes it even if convert would refuse to write "
      "the file (exit 1), and the page shows that. If the input cannot be converted at all (exit 2), there is no page.\n\n"
      "Example:\n"
      "  fca-io report camchain.yaml --with imu.yaml --to orbslam3 -o page.html\n"
      "  fca-io report camchain.yaml --model all -o models.html\n");
  options.afterwards([&conversion] { return usage_error(conversion); });
}

}  // namespace fca::cli
