// SPDX-License-Identifier: BSD-3-Clause
#include "compare_command.h"

#include "html/command_line.h"
#include "html/comparison.h"
#include "options/subcommand.h"
#include "shell/kept_inputs.h"
#include "shell/output_file.h"
#include "shell/words.h"

#include <fca/compare/compare.h>
#include <fca/formats/stated_as.h>

#include <algorithm>
#include <span>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

std::optional<std::string> problem_with(const CompareArguments& arguments) {
  if (const std::optional<std::string> error = check(arguments.reading)) return error;
  if (arguments.reading.join) return "compare lays each FILE beside REF by itself: --join has no use here";
  if (arguments.max_error_px && !(*arguments.max_error_px >= 0.0)) return "--max-error wants a number of pixels";
  if (!arguments.page.empty() && arguments.files.size() > 1) return "--report is about one FILE beside REF";
  if (arguments.force && arguments.page.empty()) return "--force is for --report: it overwrites an existing page";
  const std::ptrdiff_t from_stdin = std::ranges::count(arguments.files, "-") + (arguments.reference == "-" ? 1 : 0);
  if (from_stdin > 1) return "standard input can be read only once";
  return std::nullopt;
}

/// What of the reading options is REF's alone is not the files'.
ReadingOptions of_file(const CompareArguments& arguments) {
  ReadingOptions options = arguments.reading;
  options.with = arguments.with_of_file;
  options.crop.clear();
  options.binning = 1;
  options.resize.clear();
  options.lens_circles.clear();
  return options;
}

/// A file with one camera needs no --camera, which then says which of REF's cameras it is.
bool has_one_camera(const std::string& file, ReadingOptions options, Console& console) {
  Diagnostics unheard;
  options.cameras.reset();
  const std::optional<Calibration> calibration = read_input(file, options, console, unheard);
  return calibration && calibration->rig.cameras.size() == 1;
}

std::optional<Calibration> read_file(const std::string& file, const CompareArguments& arguments, Console& console,
                                     Diagnostics& diagnostics) {
  ReadingOptions options = of_file(arguments);
  const bool one_asked = options.cameras && options.cameras->find(',') == std::string::npos;
  if (one_asked && file != "-" && has_one_camera(file, options, console)) options.cameras.reset();
  return read_input(file, options, console, diagnostics);
}

/// Poses by the names under which the file states them.
void name_poses_as_stated(const Calibration& calibration, std::vector<Mistake>& mistakes) {
  for (Mistake& mistake : mistakes) {
    if (!mistake.pose) continue;
    const std::string key = key_of_pose(calibration, *mistake.pose);
    if (!key.empty()) mistake.subject = key;
  }
}

void exceed(ComparedFile& compared, const std::string& message, const std::string& fix = {}) {
  compared.diagnostics.error("error-limit", message, {}, fix);
  compared.code = worse(compared.code, ExitCode::kJudgedBad);
}

/// A pixel that is not there is off by more than any limit.
void judge_pixels(const CompareArguments& arguments, const ReferenceFile& reference, ComparedFile& compared) {
  const double limit_px = arguments.max_error_px.value_or(kSamePx);
  for (const CameraComparison& camera : compared.comparison->cameras) {
    if (camera.identical) continue;
    const Judgement& judgement = camera.difference.judgement;
    constexpr double kNoticeable = 1e-3;
    const double missing = judgement.coverage.unrepresentable;
    if (!(judgement.coverage.scored > 0.0)) {
      exceed(compared, camera.other + ": no pixel could be compared");
      continue;
    }
    if (judgement.error.max > limit_px) {
      exceed(compared, camera.other + ": the worst pixel is off by " + pixels(judgement.error.max) +
                           " px, more than --max-error " + pixels(limit_px));
    }
    if (missing > kNoticeable) {
      exceed(compared, camera.other + " has no pixel for " + percent(missing) + " of the image",
             std::string("if the lens ends before, --max-angle DEG ") +
                 (arguments.reading.lens_circles.empty() ? "" : "in place of --lens-circle ") + "says where");
    }
  }
  if (reference.calibration->rig.cameras.size() > compared.comparison->cameras.size())
    exceed(compared, "not every camera of the reference is there", "--camera chooses those to compare");
  if (inverses_differ(compared) && *compared.inverse_px > limit_px) {
    exceed(compared, "the inverse polynomials differ by up to " + pixels(*compared.inverse_px) + " px, more than --max-error " +
                         pixels(limit_px));
  }
}

/// What is no camera: poses, time offsets, IMU.
void judge_rest(ComparedFile& compared) {
  const RigComparison& comparison = *compared.comparison;
  for (const PoseComparison& pose : comparison.poses) {
    if (!pose.alike())
      exceed(compared, in_words(pose) + ", more than --strict allows (0.5 deg, and 5 mm or 5 % of the distance)");
  }
  for (const FactComparison& fact : comparison.facts) {
    if (!fact.alike()) exceed(compared, in_words(fact) + ", more than --strict allows (1 ms for times, else 5 %)");
  }
  if (!comparison.only_in_reference.empty())
    exceed(compared, "it does not say what the reference does: " + enumerated(comparison.only_in_reference, "and"));
}

void judge(const CompareArguments& arguments, const ReferenceFile& reference, ComparedFile& compared) {
  if (!arguments.max_error_px && !arguments.strict) return;
  for (const Mistake& mistake : compared.comparison->mistakes) exceed(compared, sentence(mistake));
  judge_pixels(arguments, reference, compared);
  if (arguments.strict) judge_rest(compared);
}

ComparedFile compared_file(const std::string& file, const ReferenceFile& reference, const CompareArguments& arguments,
                           Console& console) {
  ComparedFile compared;
  compared.file = file;
  compared.calibration = read_file(file, arguments, console, compared.diagnostics);
  if (compared.calibration) {
    const CompareOptions options = {.max_angle_rad = max_angle_rad(arguments.reading),
                                    .every_pixel = arguments.every_pixel,
                                    .by_order = arguments.reading.cameras.has_value()};
    compared.comparison = compare(reference.calibration->rig, compared.calibration->rig, options, compared.diagnostics);
    name_poses_as_stated(*compared.calibration, compared.comparison->mistakes);
    if (!changes_images(arguments.reading))
      compared.inverse_px = inverses_apart_px(*reference.calibration, *compared.calibration);
  }
  compared.code = code_of(compared.diagnostics);
  if (compared.code != ExitCode::kGood) {
    const auto& entries = compared.diagnostics.entries();
    const auto error = std::ranges::find(entries, Severity::kError, &Diagnostic::severity);
    compared.verdict = "not compared: " + error->message;
  } else {
    compared.verdict = verdict_of(compared);
    judge(arguments, reference, compared);
  }
  return compared;
}

/// --report. Nothing is written of files that could not be compared.
ExitCode write_page(const CompareArguments& arguments, const CLI::App& command, const ReferenceFile& reference,
                    const ComparedFile& compared, const Console& console) {
  if (arguments.page.empty() || !compared.comparison || compared.comparison->cameras.empty()) return ExitCode::kGood;
  if (const std::optional<std::string> problem = KeptInputs(console, arguments.reading).problem_with(arguments.page)) {
    console.error(*problem);
    return ExitCode::kUsage;
  }
  const std::string line = command_line(command, "compare", [](const std::string&) { return true; });
  const OutputFile file{arguments.page, comparison_page(reference, compared, max_angle_rad(arguments.reading), line)};
  if (const std::optional<std::string> failure = write_files(std::span(&file, 1), arguments.force, false)) {
    console.error(*failure);
    return ExitCode::kIo;
  }
  arguments.json ? console.say_aside("wrote " + file.path + "\n") : console.say("wrote " + file.path + "\n");
  return ExitCode::kGood;
}

ExitCode run_compare(const CompareArguments& arguments, const CLI::App& command, Console& console) {
  if (const std::optional<std::string> error = problem_with(arguments)) return console.refuse(ExitCode::kUsage, *error);
  ReferenceFile reference{arguments.reference, {}, {}};
  reference.calibration = read_input(arguments.reference, arguments.reading, console, reference.diagnostics);
  if (!reference.calibration) {
    // Nothing can be laid beside it.
    const ExitCode code = worse(code_of(reference.diagnostics), ExitCode::kBadInput);
    return console.refuse(code, reference.diagnostics);
  }
  if (!arguments.json) console.show(reference.diagnostics);
  ExitCode code = code_of(reference.diagnostics);
  std::vector<ComparedFile> files;
  for (const std::string& file : arguments.files) {
    files.push_back(compared_file(file, reference, arguments, console));
    const ComparedFile& compared = files.back();
    code = worse(code, compared.code);
    if (arguments.json) {
      code = worse(code, write_page(arguments, command, reference, compared, console));
      continue;
    }
    const bool some = compared.comparison && (compared.code <= ExitCode::kJudgedBad || !compared.comparison->cameras.empty());
    if (some) console.say((files.size() > 1 ? "\n" : "") + compare_text(reference, compared));
    console.show(compared.diagnostics);
    if (!some) console.say_aside("verdict: " + file + ": " + compared.verdict + "\n");
    code = worse(code, write_page(arguments, command, reference, compared, console));
  }
  if (arguments.json) console.out(compare_json(reference, files, console));
  return code;
}

void add_options(CLI::App& command, CompareArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command.add_option("REF", arguments.reference, "The calibration that counts as right; '-' is standard input")->required();
  command.add_option("FILE", arguments.files, "Calibration file(s) to lay beside it, each by itself")->required();
  add_reading_options(command, arguments.reading);
  add_lens_circle_option(command, arguments.reading);
  add_join_option(command, arguments.reading);
  command.get_option("--join")->group("");  // refused: not worth a line of the help
  take_one_each_time(*command
                          .add_option("--with-file", arguments.with_of_file,
                                      "A further part of FILE, as --with is one of REF; may be given several times")
                          ->type_name("FILE"));
  command
      .add_option("--max-error", arguments.max_error_px,
                  "Exit with 1 if a camera's worst pixel is off by more, if a camera or more than a thousandth of its image is "
                  "missing, or if one of the mistakes that people make is found, in poses, IMU and times too")
      ->type_name("PX")
      ->check(decimal_number());
  command.add_flag("--strict", arguments.strict,
                   "Exit with 1 also if poses are more than 0.5 deg, or 5 mm and 5 % of the distance, apart, time offsets more "
                   "than 1 ms, other numbers more than 5 %, or if FILE does not say what REF says; --max-error is then 0.25 "
                   "where it is not given");
  command.add_flag("--every-pixel", arguments.every_pixel, "Score every pixel of the image instead of a lattice");
  command
      .add_option("--report", arguments.page,
                  "Also write a page to look at (one HTML file): differences over the image and the angle, both rigs drawn")
      ->type_name("PATH");
  command.add_flag("--force", arguments.force, "With --report: overwrite an existing page");
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.footer(
      "Errors are measured as convert measures them: a pixel of REF's image, its ray by REF, the pixel of that ray by FILE. "
      "Cameras\n"
      "are matched by name, else by order; with --camera by the order given there. --with, --crop, --binning and --resize are\n"
      "REF's. Images of another size and the same proportions are scaled.\n\n"
      "Exit codes: 0 compared, whatever the differences; 1 --max-error or --strict not met; 2 bad input; 3 usage; 4 "
      "input/output.\n\n"
      "Example:\n"
      "  fca-io compare camchain.yaml --with imu.yaml settings.yaml --report page.html\n"
      "  fca-io compare camchain-before.yaml camchain-after.yaml --max-angle 97.5 --max-error 0.5\n");
  command.callback([&arguments, &command, &run] {
    run = [&arguments, &command](Console& console) { return run_compare(arguments, command, console); };
  });
}

}  // namespace

void add_compare_command(CLI::App& app, CompareArguments& arguments, std::function<ExitCode(Console&)>& run) {
  add_subcommand(
      app, "compare",
      "How calibrations of any formats and models differ: pixels, degrees, poses, IMU, time; and which mistake it is",
      [&arguments, &run](CLI::App& command) { add_options(command, arguments, run); });
}

}  // namespace fca::cli
