// SPDX-License-Identifier: BSD-3-Clause
#include "compare.h"

#include "inputs.h"
#include "limits.h"
#include "output.h"
#include "shell/words.h"

#include <fca/rig/limits.h>

namespace fca::cli {

namespace {

std::optional<std::string> usage_error(const CompareArguments& arguments) {
  const CompareRequest& request = arguments.request;
  if (request.reference.join) return "compare compares each FILE with REF by itself: --join has no use here";
  if (!arguments.page.empty() && request.files.size() > 1) return "--report is about one FILE and REF";
  if (arguments.force && arguments.page.empty()) return "--force is for --report: it overwrites an existing page";
  if (reads_of_standard_input(request.files) + reads_of_standard_input(request.reference.files) > 1)
    return "standard input can be read only once";
  return std::nullopt;
}

}  // namespace

void add_compare_options(Options& options, CompareArguments& arguments) {
  CompareRequest& request = arguments.request;
  options.one_positional("REF", "The calibration that counts as right; '-' is standard input", request.reference.files);
  options.positional("FILE", "Calibration file(s) to compare with it, each by itself", request.files);
  add_input_options(options, request.reference);
  add_lens_circle_option(options, request.reference);
  add_imu_rate_option(options, request.reference);
  add_join_option(options, request.reference);
  options.hide({"--join"});  // refused: not worth a line of the help
  options.each("--with-file", "FILE", "A further part of FILE, as --with is one of REF; may be given several times",
               request.parts);
  options.group(OptionGroup::kLens);
  options.number("--focus", "DEG",
                 "Rays up to so many degrees from the axis count: from them the best rotation is sought, and they make the "
                 "verdict. Unlike with --max-angle the rest is still measured, with that rotation",
                 [&request](double degrees) -> std::optional<std::string> {
                   if (!(degrees > 0.0 && degrees <= 180.0)) return "--focus wants degrees from the axis in (0, 180]";
                   request.focus_rad = degrees / kDegreesPerRadian;
                   return std::nullopt;
                 });
  options.group(OptionGroup::kProof);
  options.number("--distance", "METRES",
                 "Points are so far from the camera, and a shift of the projection centre is sought with the best rotation "
                 "(default: infinitely far, a rotation alone)",
                 [&request](double metres) -> std::optional<std::string> {
                   if (problem_with_baseline(metres).is_said())
                     return "--distance wants metres in (0, " + std::to_string(static_cast<int>(kLongestDistance)) + ")";
                   request.distance_m = metres;
                   return std::nullopt;
                 });
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
      "Where a camera is turned and its poses turn back, so that both cancel, the verdict is about what remains.\n\n"
      "Exit codes: 0 compared, whatever the differences; 1 --max-error or --strict not met; 2 bad input; 3 usage; 4 "
      "input/output.\n\n"
      "Example:\n"
      "  fca-io compare camchain.yaml --with imu.yaml settings.yaml --report page.html\n"
      "  fca-io compare before.yaml after.yaml --max-angle 97.5 --max-error 0.5\n"
      "  fca-io compare before.yaml after.yaml --focus 40 --distance 2\n");
  options.afterwards([&arguments] { return usage_error(arguments); });
}

}  // namespace fca::cli
