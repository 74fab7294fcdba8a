// SPDX-License-Identifier: BSD-3-Clause
// What a calibration file means, and who reads it.
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
  const consumers::Consumer* program = nullptr;  ///< Also asked what it reads from the file; null: none.
};

/// What a file means if its four coefficients are those of this lens.
struct ReadingAs {
  std::optional<OpenCvModel> model;     ///< The lens that was chosen; nothing where that is not open.
  std::optional<ImageSize> image_size;  ///< The size of images that was chosen; nothing where that is not open.
  Calibration calibration;
};

struct Reading {
  Status status = Status::kDone;
  std::optional<Calibration> calibration;  ///< Nothing where it could not be read.
  /// Of an OpenCV file that does not say which of two lenses its four coefficients are: as either. `calibration` is nothing
  /// then, and the question a warning.
  std::vector<ReadingAs> readings;
  Readers readers;                      ///< The programs of its format.
  std::optional<ProgramReading> asked;  ///< The request's.
  Diagnostics diagnostics;
};

[[nodiscard]] Reading read(const ReadRequest& request, Files& files);

/// The one camera of a calibration, with numbers that are a camera's.
struct CameraReading {
  Status status = Status::kDone;
  std::optional<Camera> camera;  ///< Nothing where there is none, or several.
  Diagnostics diagnostics;
};

[[nodiscard]] CameraReading read_camera(const Inputs& inputs, Files& files);

/// "Kalibr pinhole-equidistant": what a format calls a model, after its program.
[[nodiscard]] std::string name_in(const Format& format, const StoredModel& row);
/// The same of all formats.
[[nodiscard]] std::vector<std::string> names_elsewhere(std::string_view model);

/// Is the pose from a file that does not specify the unit of its translation?
[[nodiscard]] bool has_assumed_unit(const PoseEdge& edge, const Calibration& calibration);

}  // namespace fca
