// SPDX-License-Identifier: BSD-3-Clause
#include "conversion.h"

#include "output_name.h"
#include "words.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>

namespace fca::cli {

namespace {

/// Only a folder has room for a second file; elsewhere it is a loss, and said.
void place_outputs(const ConvertArguments& arguments, ConvertOutcome& outcome) {
  const bool folder = names_folder(arguments.output);
  for (std::size_t i = 0; i < outcome.written.files.size(); ++i) {
    const Written::File& file = outcome.written.files[i];
    if (i > 0 && !folder) {
      outcome.written.losses.push_back({"second-file-dropped", file.document.source().name + " (the IMU's noise and rate)",
                                        "a camchain has no place for it and there is one output",
                                        "-o FOLDER/ writes it beside the camchain"});
      continue;
    }
    outcome.outputs.push_back({output_path(arguments.output, outcome.input, *outcome.to, outcome.written, i),
                               file.document.bytes(), file.cameras, file.programs});
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
    ProofResult proof = prove(*consumer, output.bytes, load_options(outcome.written), rig, output.cameras);
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
    outcome.diagnostics.warning(
        "poor-fit",
        camera.source.name + ": " + camera.report->to_model + " does not describe this lens: rms " + pixels(error.rms) +
            " px, worst pixel " + pixels(error.max) + " px",
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

}  // namespace

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
  WriteOptions options;
  options.sensor = arguments.sensor;
  options.layout = arguments.orbslam3_layout;
  options.frame_rate_hz = arguments.fps;
  std::optional<Written> written = outcome.to->write(base, rig, options, outcome.diagnostics);
  if (!written) return failed();
  const bool unchanged = base != nullptr && written->files.front().document.bytes() == base->source().bytes;
  if (base != nullptr && !unchanged && !arguments.no_verify) {
    if (const std::optional<std::string> refusal = refused(*written)) {
      // The input's own layout (OpenVINS' first line in a camchain) is no base for a file that its program is to read.
      options.anew = true;
      written = outcome.to->write(base, rig, options, outcome.diagnostics);
      if (!written) return failed();
      outcome.diagnostics.note("layout-not-kept",
                               "written anew, without the input's comments, because its layout cannot be kept: " + *refusal);
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

}  // namespace fca::cli
