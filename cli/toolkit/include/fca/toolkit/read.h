// SPDX-License-Identifier: BSD-3-Clause
// Reads a calibration, and lists the programs that read its files.
#pragma once

#include <fca/formats/proof.h>
#include <fca/toolkit/inputs.h>
#include <fca/toolkit/programs.h>
#include <fca/toolkit/status.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

struct ReadRequest {
  Inputs inputs;
  const consumers::Consumer* program = nullptr;  ///< Also report what this program reads from the file. Null: no program.
};

/// One reading of an ambiguous file: the calibration under one assumption.
struct ReadingAs {
  std::optional<OpenCvModel> model;     ///< The assumed lens model. nullopt if the lens model is not ambiguous.
  std::optional<ImageSize> image_size;  ///< The assumed image size. nullopt if the image size is not ambiguous.
  Calibration calibration;
};

/// The result of read().
struct Reading {
  Status status = Status::kDone;
  std::optional<Calibration> calibration;  ///< nullopt if the files cannot be read or are ambiguous.
  /// The possible readings of an ambiguous file: an OpenCV file whose four coefficients can be those of two lens models, or a
  /// file with a lens for each of several image sizes. `calibration` is then nullopt, and a warning describes the choice.
  std::vector<ReadingAs> readings;
  Readers readers;                      ///< The programs that read the format.
  std::optional<ProgramReading> asked;  ///< What the request's program reads. nullopt if the request has no program.
  Diagnostics diagnostics;
};

/// Reads the files of a request. Errors are in the result's diagnostics.
[[nodiscard]] Reading read(const ReadRequest& request, Files& files);

/// The result of read_camera().
struct CameraReading {
  Status status = Status::kDone;
  std::optional<Camera> camera;  ///< nullopt with errors.
  Diagnostics diagnostics;
};

/// Reads the only camera of a calibration. It is an error if there is no camera or more than one, or if the parameters are not
/// valid for the camera model.
[[nodiscard]] CameraReading read_camera(const Inputs& inputs, Files& files);

/// The name of a model in a format: the format's program and the program's word, "Kalibr pinhole-equidistant".
[[nodiscard]] std::string name_in(const Format& format, const StoredModel& row);
/// The names of that model (by our id) in all formats that are written.
[[nodiscard]] std::vector<std::string> names_elsewhere(std::string_view model);

/// True if the pose comes from a file that does not specify the unit of its translation.
[[nodiscard]] bool has_assumed_unit(const PoseEdge& edge, const Calibration& calibration);

}  // namespace fca
