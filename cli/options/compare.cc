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
  if (request.reference.join) return "compare compares each FILE alone with REF: --join has no effect here";
  if (!arguments.page.empty() && request.files.size() > 1) return "--report needs exactly one FILE";
  if (arguments.force && arguments.page.empty()) return "--force is for --report: it overwrites an existing page";
  if (reads_of_standard_input(request.files) + reads_of_standard_input(request.reference.files) > 1)
    return "standard input can be read only once";
  return std::nullopt;
}

}  // namespace

void add_compare_options(Options& options, CompareArguments& arguments) {
  CompareRequest& request = arguments.request;
  options.one_positional("REF", "The reference calibration; '-' is standard input", request.reference.files);
  options.positional("FILE", "Calibration file(s) to compare with REF, one by one", request.files);
  add_input_options(options, request.reference);
  add_lens_circle_option(options, request.reference);
  add_imu_rate_option(options, request.reference);
  add_join_option(options, request.reference);
  options.hide({"--join"});  // refused: not worth a line of the help
  options.each("--with-file", "FILE", "Another part of FILE's calibration (--with is for REF's); repeatable", request.parts);
  options.group(OptionGroup::kLens);
  options.number("--focus", "DEG",
                 "Use only rays up to this angle from the axis for the best rotation and for the verdict. Unlike with "
                 "--max-angle, compare still measures the other rays, with that rotation",
                 [&request](double degrees) -> std::optional<std::string> {
                   if (!(degrees > 0.0 && degrees <= 180.0)) return "--focus wants degrees from the axis in (0, 180]";
                   request.focus_rad = degrees / kDegreesPerRadian;
                   return std::nullopt;
                 });
  options.group(OptionGroup::kProof);
  options.number(
      "--distance", "METRES",
      "Distance of the points from the camera: compare then finds the best rotation together with a shift of the "
      "projection centre (default: infinitely far, a rotation alone); no shift is sought where poses cancel the turn",
      [&request](double metres) -> std::optional<std::string> {
        if (problem_with_baseline(metres).is_said())
          return "--distance wants metres in (0, " + std::to_string(static_cast<int>(kLongestDistance)) + ")";
        request.distance_m = metres;
        return std::nullopt;
      });
  add_max_error_option(options,
                       "Exit with 1 if a camera's worst pixel is off by more, if a camera or more than 0.1 % of its image is "
                       "missing, or if compare finds a common mistake (also in poses, IMU and times)",
                       request.max_error_px);
  add_strict_option(options,
                    "Also exit with 1 if poses differ by more than 0.5 deg, or by more than 5 mm and 5 % of the distance; if "
                    "time offsets differ by more than 1 ms, or other numbers by more than 5 %; or if FILE lacks something that "
                    "REF contains. The default of --max-error is then 0.25",
                    request.strict);
  add_every_pixel_option(options, request.every_pixel);
  options.group(OptionGroup::kOutput);
  options.value(
      "--report", "PATH",
      "Also write a page (one HTML file) with the differences over the image and the angle, and drawings of both rigs",
      arguments.page);
  add_force_option(options, "With --report: overwrite an existing page", arguments.force);
  add_verbose_option(options, "Also the errors over the angle from the axis, as a table", arguments.verbose);
  add_json_option(options, arguments.json);
  options.footer(
      "compare measures errors as convert does: REF gives the ray of a pixel of its image, and FILE gives the pixel of that "
      "ray. It matches cameras by name, else by order; with --camera by the order given there. --with, --crop, --binning and "
      "--resize are for REF. It scales images of another size that have the same proportions.\n\n"
      "If a camera is turned and its poses turn back by the same angle, the two cancel, and the verdict counts only the "
      "rest.\n\n"
      "Exit codes: 0 compared, whatever the differences; 1 --max-error or --strict not met; 2 bad input; 3 usage; 4 "
      "input/output.\n\n"
      "Example:\n"
      "  fca-io compare camchain.yaml --with imu.yaml settings.yaml --report page.html\n"
      "  fca-io compare before.yaml after.yaml --max-angle 97.5 --max-error 0.5\n"
      "  fca-io compare before.yaml after.yaml --focus 40 --distance 2\n");
  options.afterwards([&arguments] { return usage_error(arguments); });
}

}  // namespace fca::cli
