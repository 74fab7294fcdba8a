// SPDX-License-Identifier: BSD-3-Clause
#include "output_place.h"

#include "kept_inputs.h"
#include "output_name.h"

#include <algorithm>

namespace fca::cli {

namespace {

/// Files that name each other, and no place for them?
bool lack_folder(const ConvertArguments& arguments, const Written& written) {
  const bool named = std::ranges::any_of(written.files, &Written::File::named);
  return named && !arguments.json && !arguments.in_place && (arguments.output.empty() || arguments.output == "-");
}

/// One file per camera, and only one place to put them?
bool needs_folder(const ConvertArguments& arguments, const Written& written) {
  if (camera_files(written) < 2 || names_folder(arguments.output)) return false;
  if (arguments.output.empty() && arguments.json) return false;
  return arguments.output.find("{camera}") == std::string::npos;
}

}  // namespace

bool have_place(const ConvertArguments& arguments, const Written& written, ConvertOutcome& outcome) {
  if (lack_folder(arguments, written)) {
    outcome.diagnostics.error("one-output", written.headline + ": these are " + std::to_string(written.files.size()) + " files",
                              {}, "-o FOLDER/, or -o FILE, which has the others beside it");
  } else if (needs_folder(arguments, written)) {
    outcome.diagnostics.error(
        "one-camera-per-file",
        // An OpenCV file of camera_calibration's keys, for one, though there are others for several cameras.
        (outcome.to->many_cameras ? written.headline + ": one" : std::string(outcome.to->title) + " holds one") +
            " camera per file, and here are " + std::to_string(camera_files(written)),
        {},
        "-o FOLDER/, a pattern such as -o '{stem}.{camera}" + extension_of(written.files.front(), *outcome.to) +
            "', or --camera to choose one");
  } else {
    return true;
  }
  outcome.code = ExitCode::kUsage;
  return false;
}

bool place_outputs(const ConvertArguments& arguments, ConvertOutcome& outcome) {
  const bool folder = names_folder(arguments.output);
  const std::string& place = arguments.in_place ? arguments.into : arguments.output;
  for (std::size_t i = 0; i < outcome.written.files.size(); ++i) {
    const Written::File& file = outcome.written.files[i];
    if (i > 0 && file.cameras.empty() && !folder) {
      std::erase_if(outcome.written.defaults, [&file](const DefaultedValue& value) {
        return value.key.ends_with("(" + file.document.source().name + ")");
      });
      outcome.written.losses.push_back({"second-file-dropped", file.document.source().name + " (the IMU's noise and rate)",
                                        "a camchain has no place for it and there is one output",
                                        "-o FOLDER/ writes it beside the camchain"});
      continue;
    }
    outcome.outputs.push_back({output_path(place, outcome.input, *outcome.to, outcome.written, i), file.document.bytes(),
                               file.cameras, file.programs});
    if (const std::string problem = misnamed(outcome.outputs.back().path, file.document);
        !problem.empty() && !arguments.in_place)
      outcome.diagnostics.note("extension", problem);
  }
  // Cameras that no file holds are listed as lost; their fits are nobody's business.
  std::erase_if(outcome.cameras, [&outcome](const CameraOutcome& camera) {
    return std::ranges::none_of(outcome.outputs, [&camera](const ConvertOutcome::Output& output) {
      return std::ranges::find(output.cameras, camera.source.name) != output.cameras.end();
    });
  });
  const KeptInputs images(arguments.reading);
  for (const ConvertOutcome::Output& output : outcome.outputs) {
    const std::optional<std::string> problem = images.problem_with(output.path);
    if (!problem) continue;
    outcome.diagnostics.error("overwrites-input", *problem);
    outcome.code = ExitCode::kUsage;
    return false;
  }
  return true;
}

}  // namespace fca::cli
