// SPDX-License-Identifier: BSD-3-Clause
#include "convert_command.h"

#include "output_file.h"
#include "words.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// A value that an option of some formats takes, as an error if this format has none such.
std::optional<std::string> not_among(const std::string& value, std::string_view option, std::string_view kind,
                                     std::span<const std::string_view> known) {
  if (value.empty() || std::ranges::find(known, value) != known.end()) return std::nullopt;
  if (known.empty()) return std::string(option) + " is for orbslam3";
  const std::vector<std::string> names(known.begin(), known.end());
  const std::vector<std::string> near = nearest(value, names);
  return "unknown " + std::string(kind) + " '" + value + "'" +
         (near.empty() ? "; there are " + enumerated(names) : "; did you mean " + enumerated(near, "or") + "?");
}

/// The first "{...}" of a pattern that output_path() does not fill in.
std::optional<std::string> unknown_placeholder(std::string_view pattern) {
  constexpr std::array<std::string_view, 3> kKnown = {"{stem}", "{camera}", "{format}"};
  for (std::size_t at = pattern.find('{'); at != std::string_view::npos; at = pattern.find('{', at + 1)) {
    const std::size_t end = pattern.find('}', at);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view placeholder = pattern.substr(at, end - at + 1);
    if (std::ranges::find(kKnown, placeholder) == kKnown.end()) return std::string(placeholder);
  }
  return std::nullopt;
}

std::optional<std::string> usage_error(const ConvertArguments& arguments) {
  if (const std::optional<std::string> error = check(arguments.reading)) return error;
  if (find_format(arguments.to) == nullptr) return unknown_format(arguments.to);
  if (!arguments.model.empty() && find_model(arguments.model) == nullptr) return unknown_model(arguments.model);
  if (arguments.fps && !(*arguments.fps > 0.0 && *arguments.fps < 1e6)) return "--fps wants a positive number";
  if (arguments.baseline_m && !(*arguments.baseline_m > 0.0 && *arguments.baseline_m < 1e6))
    return "--baseline wants a positive number of metres";
  if (arguments.max_error_px && !(*arguments.max_error_px >= 0.0)) return "--max-error wants a number of pixels";
  const Format& to = *find_format(arguments.to);
  if (const auto error = not_among(arguments.sensor, "--sensor", "sensor mode", to.modes)) return error;
  if (const auto error = not_among(arguments.orbslam3_layout, "--orbslam3-layout", "layout", to.layouts)) return error;
  const bool many = arguments.inputs.size() > 1;
  const bool one_path = !arguments.output.empty() && arguments.output.find('{') == std::string::npos &&
                        !fs::is_directory(arguments.output) && !arguments.output.ends_with('/');
  if (many && one_path) return "several inputs need -o FOLDER/ or a pattern such as -o 'out/{stem}.{format}.yaml'";
  if (many && arguments.output.empty() && !arguments.json) return "several inputs need -o FOLDER/ (or --json)";
  if (const std::optional<std::string> unknown = unknown_placeholder(arguments.output))
    return "-o: there is no placeholder " + *unknown + "; there are {stem}, {camera} and {format}";
  return std::nullopt;
}

std::string replaced(std::string text, std::string_view placeholder, std::string_view value) {
  for (std::size_t at = text.find(placeholder); at != std::string::npos; at = text.find(placeholder, at + value.size())) {
    text.replace(at, placeholder.size(), value);
  }
  return text;
}

/// Where the file number `index` of a conversion goes; empty: standard output.
std::string output_path(const ConvertArguments& arguments, const std::string& input, const Written& written,
                        std::size_t index) {
  if (arguments.output.empty() || arguments.output == "-") return "";
  const std::string stem = input == "-" ? "stdin" : fs::path(input).stem().string();
  const Format& format = *find_format(arguments.to);
  if (arguments.output.find('{') != std::string::npos) {
    std::string camera;
    for (const std::string& name : written.files[index].cameras) camera += (camera.empty() ? "" : "-") + name;
    return replaced(replaced(replaced(arguments.output, "{stem}", stem), "{format}", format.id), "{camera}", camera);
  }
  if (!fs::is_directory(arguments.output) && !arguments.output.ends_with('/')) return arguments.output;
  const std::string name =
      index == 0 ? stem + "." + std::string(format.id) + ".yaml" : written.files[index].document.source().name;
  return (fs::path(arguments.output) / name).string();
}

/// Only a folder has room for a second file; elsewhere it is a loss, and said.
void place_outputs(const ConvertArguments& arguments, ConvertOutcome& outcome) {
  const bool folder = !arguments.output.empty() && (fs::is_directory(arguments.output) || arguments.output.ends_with('/'));
  for (std::size_t i = 0; i < outcome.written.files.size(); ++i) {
    const Written::File& file = outcome.written.files[i];
    if (i > 0 && !folder) {
      outcome.written.losses.push_back({"second-file-dropped", file.document.source().name + " (the IMU's noise and rate)",
                                        "a camchain has no place for it and there is one output",
                                        "-o FOLDER/ writes it beside the camchain"});
      continue;
    }
    outcome.outputs.push_back(
        {output_path(arguments, outcome.input, outcome.written, i), file.document.bytes(), file.cameras, file.programs});
  }
  // Cameras that no file holds are listed as lost; their fits are nobody's business.
  std::erase_if(outcome.cameras, [&outcome](const CameraOutcome& camera) {
    return std::ranges::none_of(outcome.outputs, [&camera](const ConvertOutcome::Output& output) {
      return std::ranges::find(output.cameras, camera.source.name) != output.cameras.end();
    });
  });
}

/// A file without a camera was probably meant as a further part.
void explain_no_camera(const ConvertArguments& arguments, const std::string& input, const Calibration& calibration,
                       Diagnostics& diagnostics) {
  const std::string what = calibration.rig.imus.empty() ? "no camera" : "an IMU and no camera";
  diagnostics.error("no-camera", input + " holds " + what, {input, 0, 0},
                    "did you mean: fca-io convert camchain.yaml --with " + input + " --to " + arguments.to);
}

Rig converted_rig(const Calibration& calibration, const std::vector<CameraOutcome>& cameras,
                  const ConvertArguments& arguments) {
  Rig rig = calibration.rig;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    rig.cameras[i] = cameras[i].target;
    if (arguments.fps) rig.cameras[i].frame_rate_hz = arguments.fps;
  }
  if (arguments.baseline_m) rig.baseline_m = arguments.baseline_m;
  return rig;
}

std::string disagreement(const ProofResult& proof) {
  if (!proof.loads) return "it would refuse the file: " + enumerated(proof.refusals);
  if (!proof.poses_agree) return "an element of its poses differs by " + text::format_short(proof.max_diff_pose, 3);
  if (proof.compared_share == 0.0) return "it has no pixel where we have one";
  return "its pixels differ by up to " + pixels(proof.max_diff_px) + " px";
}

consumers::LoadOptions load_options(const Written& written) {
  consumers::LoadOptions options;
  if (!written.sensor.empty()) options.sensor = written.sensor;
  return options;
}

/// `unchanged`: the output is the input's bytes. Then a program's refusal is the input's own defect: told, not held against us.
void verify(const Rig& rig, const ConvertOutcome::Output& output, bool unchanged, ConvertOutcome& outcome) {
  for (const std::string& id : output.programs) {
    const consumers::Consumer* consumer = consumers::find_consumer(id);
    if (consumer == nullptr) continue;
    ProofResult proof = prove(*consumer, output.bytes, load_options(outcome.written), rig,
                              output.cameras);
    const std::string program(consumer->program);
    if (!proof.agrees() && unchanged) {
      outcome.diagnostics.warning(
          "program-refuses",
          "nothing was changed, and " + program + " does not understand the input itself: " + disagreement(proof), {},
          outcome.to->layouts.empty() ? "" : "--orbslam3-layout v1 writes the settings anew, as stock V1.0 reads them");
    } else if (!proof.agrees()) {
      outcome.diagnostics.error("proof-failed",
                                program + " would not understand what was to be written: " + disagreement(proof));
      outcome.code = worse(outcome.code, ExitCode::kJudgedBad);
    }
    outcome.proofs.push_back(std::move(proof));
  }
}

/// A model that does not suit the lens is the user's choice, but one to know of.
void warn_of_poor_fits(ConvertOutcome& outcome) {
  constexpr double kPoorRms = 1.0;   // px
  constexpr double kPoorMax = 10.0;  // px
  for (const CameraOutcome& camera : outcome.cameras) {
    if (!camera.report || camera.report->exact) continue;
    const ErrorSummary& error = camera.report->judgement.error;
    if (error.rms <= kPoorRms && error.max <= kPoorMax) continue;
    outcome.diagnostics.warning("poor-fit",
                                camera.source.name + ": " + camera.report->to_model + " does not describe this lens: rms " +
                                    pixels(error.rms) + " px, worst pixel " + pixels(error.max) + " px",
                                {}, "fca-io models " + outcome.input + " compares all models; --max-angle DEG if the corners are black");
  }
}

/// Why a program would not load what is written for it; nothing if all load it.
std::optional<std::string> refused(const Written& written) {
  for (const Written::File& file : written.files) {
    for (const std::string& id : file.programs) {
      const consumers::Consumer* consumer = consumers::find_consumer(id);
      if (consumer == nullptr) continue;
      const consumers::ConsumerView view = consumer->load(file.document.bytes(), load_options(written));
      if (!view.loads()) return view.refusals.front();
    }
  }
  return std::nullopt;
}

void judge_limits(const ConvertArguments& arguments, ConvertOutcome& outcome) {
  for (const CameraOutcome& camera : outcome.cameras) {
    if (!arguments.max_error_px || !camera.report) continue;
    const double worst = camera.report->judgement.error.max;
    if (worst <= *arguments.max_error_px) continue;
    outcome.diagnostics.error("error-limit", camera.source.name + ": the worst pixel is off by " + pixels(worst) +
                                                 " px, more than --max-error " + pixels(*arguments.max_error_px));
    outcome.code = ExitCode::kJudgedBad;
  }
  if (arguments.strict && !outcome.written.losses.empty()) {
    std::vector<std::string> what;
    for (const Loss& loss : outcome.written.losses) what.push_back(loss.what);
    outcome.diagnostics.error("strict-loss", "the target cannot carry " + enumerated(what) + ", and --strict was given");
    outcome.code = ExitCode::kJudgedBad;
  }
}

ConvertOutcome convert_input(const std::string& input, const ConvertArguments& arguments, Console& console) {
  ConvertOutcome outcome;
  outcome.input = input;
  outcome.to = find_format(arguments.to);
  const std::optional<Calibration> calibration = read_input(input, arguments.reading, console, outcome.diagnostics);
  const auto failed = [&outcome]() -> ConvertOutcome {
    const ExitCode code = code_of(outcome.diagnostics);
    outcome.code = worse(outcome.code, code == ExitCode::kGood ? ExitCode::kBadInput : code);
    return std::move(outcome);
  };
  if (!calibration) return failed();
  outcome.from = calibration->format;
  if (calibration->rig.cameras.empty()) {
    explain_no_camera(arguments, input, *calibration, outcome.diagnostics);
    return failed();
  }
  std::optional<std::vector<CameraOutcome>> cameras = convert_cameras(
      calibration->rig.cameras, *outcome.to, {arguments.model, max_angle_rad(arguments.reading)}, outcome.diagnostics);
  if (!cameras) return failed();
  outcome.cameras = *std::move(cameras);

  if (arguments.baseline_m && calibration->rig.cameras.size() > 1) {
    outcome.diagnostics.error("baseline-contradicts",
                              "--baseline is for one camera of a rectified pair or depth sensor; here are " +
                                  std::to_string(calibration->rig.cameras.size()) + " cameras with poses of their own",
                              {input, 0, 0}, "choose one with --camera");
    outcome.code = ExitCode::kUsage;
    return failed();
  }

  const Rig rig = converted_rig(*calibration, outcome.cameras, arguments);
  // Same format in and out: the input document is edited, nothing is composed anew.
  const text::Document* base = calibration->format == outcome.to ? &calibration->documents.front() : nullptr;
  const WriteOptions options = {arguments.sensor, arguments.orbslam3_layout, arguments.fps};
  std::optional<Written> written = outcome.to->write(base, rig, options, outcome.diagnostics);
  if (!written) return failed();
  const bool unchanged = base != nullptr && written->files.front().document.bytes() == base->source().bytes;
  if (base != nullptr && !unchanged && !arguments.no_verify) {
    if (const std::optional<std::string> refusal = refused(*written)) {
      // The input's own layout (OpenVINS' first line in a camchain) is no base for a file that its program is to read.
      written = outcome.to->write(nullptr, rig, options, outcome.diagnostics);
      if (!written) return failed();
      outcome.diagnostics.note("layout-not-kept", "written anew, without the input's comments, because its layout cannot be kept: " +
                                                      *refusal);
    }
  }
  outcome.written = *std::move(written);
  place_outputs(arguments, outcome);
  if (!arguments.no_verify) {
    for (const ConvertOutcome::Output& output : outcome.outputs) verify(rig, output, unchanged, outcome);
  }
  warn_of_poor_fits(outcome);
  judge_limits(arguments, outcome);
  return outcome;
}

/// Refuses before anything is written that two outputs have one path.
bool collide(const std::vector<ConvertOutcome>& outcomes, const Console& console) {
  std::set<std::string> seen;
  for (const ConvertOutcome& outcome : outcomes) {
    for (const ConvertOutcome::Output& output : outcome.outputs) {
      if (output.path.empty() || seen.insert(output.path).second) continue;
      static_cast<void>(console.refuse(ExitCode::kUsage, "two outputs would be written to " + output.path,
                                       "use a pattern such as -o 'out/{stem}.{format}.yaml'"));
      return true;
    }
  }
  return false;
}

void write_outputs(const ConvertArguments& arguments, ConvertOutcome& outcome, const Console& console) {
  if (outcome.code != ExitCode::kGood || arguments.dry_run) return;
  // All or nothing: what would be refused is refused before the first file is written.
  for (const ConvertOutcome::Output& output : outcome.outputs) {
    if (output.path.empty() || arguments.force || !fs::is_regular_file(output.path)) continue;
    outcome.diagnostics.error("cannot-write", output.path + " exists; --force overwrites it");
    outcome.code = ExitCode::kIo;
    return;
  }
  for (const ConvertOutcome::Output& output : outcome.outputs) {
    if (output.path.empty()) {
      if (!arguments.json) console.out(output.bytes);
      continue;
    }
    if (arguments.output.ends_with('/')) {
      std::error_code error;
      fs::create_directories(arguments.output, error);
    }
    if (const std::optional<std::string> failure = write_file(output.path, output.bytes, arguments.force, arguments.fsync)) {
      outcome.diagnostics.error("cannot-write", *failure);
      outcome.code = ExitCode::kIo;
      return;
    }
  }
}

ExitCode run_convert(const ConvertArguments& arguments, Console& console) {
  if (const std::optional<std::string> error = usage_error(arguments)) return console.refuse(ExitCode::kUsage, *error);
  std::vector<ConvertOutcome> outcomes;
  for (const std::string& input : arguments.inputs) outcomes.push_back(convert_input(input, arguments, console));
  if (collide(outcomes, console)) return ExitCode::kUsage;

  ExitCode code = ExitCode::kGood;
  // Several inputs: every diagnostic names its file itself.
  const bool file_on_stdout = arguments.output.empty() || arguments.output == "-";
  for (ConvertOutcome& outcome : outcomes) {
    write_outputs(arguments, outcome, console);
    if (!arguments.json) {
      if (!outcome.cameras.empty() && !outcome.outputs.empty()) {
        const std::string report = convert_text(outcome, !arguments.dry_run);
        file_on_stdout && !arguments.dry_run ? console.say_aside(report) : console.say(report);
      }
      console.show(outcome.diagnostics);
    }
    code = worse(code, outcome.code);
  }
  if (arguments.json) console.out(convert_json(outcomes, console));
  return code;
}

}  // namespace

void add_convert_command(CLI::App& app, ConvertArguments& arguments, std::function<ExitCode(Console&)>& run) {
  CLI::App& command =
      *app.add_subcommand("convert", "Convert a calibration to another format, and to another camera model if need be");
  command.add_option("INPUT", arguments.inputs, "Calibration file(s); '-' is standard input")->required();
  command.add_option("--to", arguments.to, "The format to write")->required()->type_name("FORMAT");
  command
      .add_option("--model", arguments.model,
                  "The camera model to write (default: kept, else the best that the stock program reads)")
      ->type_name("MODEL");
  command
      .add_option("-o,--output", arguments.output,
                  "A path, a folder, or a pattern with {stem}, {camera}, {format} (default: standard output)")
      ->type_name("PATH");
  add_reading_options(command, arguments.reading);
  command
      .add_option("--sensor", arguments.sensor,
                  "orbslam3: mono, stereo, rgbd, mono-inertial or stereo-inertial (default: the richest the input serves)")
      ->type_name("MODE");
  command
      .add_option("--orbslam3-layout", arguments.orbslam3_layout,
                  "v1 (stock V1.0), old (before V1.0), orbslam2 or slam_no_opt (default: the input's, else v1)")
      ->type_name("LAYOUT");
  command.add_option("--fps", arguments.fps, "Frame rate, for formats that state it")->type_name("HZ")->check(decimal_number());
  command.add_option("--baseline", arguments.baseline_m, "Baseline of a rectified pair or depth sensor")
      ->type_name("METRES")
      ->check(decimal_number());
  command.add_option("--max-error", arguments.max_error_px, "Fail (exit 1, nothing written) if the worst pixel is off by more")
      ->type_name("PX")
      ->check(decimal_number());
  command.add_flag("--strict", arguments.strict, "Fail if anything of the input cannot be carried");
  command.add_flag("--no-verify", arguments.no_verify, "Do not ask the real program's reader about the written bytes");
  command.add_flag("--dry-run", arguments.dry_run, "Report, write nothing");
  command.add_flag("--force", arguments.force, "Overwrite existing files");
  command.add_flag("--fsync", arguments.fsync, "Force the file to disk before it replaces an old one");
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.footer(
      "Example:\n"
      "  fca-io convert camchain.yaml --with imu.yaml --to orbslam3 -o settings.yaml\n"
      "  fca-io convert camchain.yaml --to orbslam3 --model eucm --max-angle 97.5 -o eucm.yaml\n");
  command.callback([&] { run = [&arguments](Console& console) { return run_convert(arguments, console); }; });
}

}  // namespace fca::cli
