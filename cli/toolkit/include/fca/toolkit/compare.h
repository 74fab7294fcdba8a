// SPDX-License-Identifier: BSD-3-Clause
// Compares calibration files of any formats and camera models.
#pragma once

#include <fca/compare/report.h>
#include <fca/rectify/vertical_disparity.h>
#include <fca/toolkit/inputs.h>
#include <fca/toolkit/status.h>

#include <optional>
#include <string>
#include <vector>

namespace fca {

struct CompareRequest {
  /// The reference. Its camera choice and its largest angle also apply to the other files.
  Inputs reference;
  std::vector<std::string> files;        ///< Each of these files is compared with the reference.
  std::vector<std::string> parts;        ///< Additional parts to read with each of `files`. The reference's are in `reference`.
  std::optional<double> max_error_px;    ///< The status is kRejected if a pixel differs by more.
  bool strict = false;                   ///< The status is kRejected if lenses, poses, time offsets or other numbers differ.
  bool every_pixel = false;              ///< Compare every pixel of the image instead of a lattice of pixels.
  std::optional<double> focus_rad = {};  ///< Largest angle from the axis of the rays that decide (CompareOptions).
  std::optional<double> distance_m = {};  ///< Distance of the compared points. Infinite if not set (CompareOptions).
};

/// The reference file and its contents.
struct ReferenceFile {
  std::string file;
  std::optional<Calibration> calibration;  ///< nullopt if the file cannot be read.
  Diagnostics diagnostics;
};

/// One file, and its differences from the reference.
struct ComparedFile {
  std::string file;
  Status status = Status::kDone;
  std::optional<Calibration> calibration;   ///< nullopt if the file cannot be read.
  std::optional<RigComparison> comparison;  ///< Set if `calibration` is set.
  /// For two OCamCalib files: the largest distance [px] between the pixels to which their inverse polynomials (world2cam)
  /// project the same ray, over the rays of the reference's image. The comparison of camera models does not use these
  /// polynomials. nullopt for other formats and for images of different sizes.
  std::optional<double> inverse_px;
  /// The error in the images of the reference's stereo pair if they are rectified with the calibration of this file. nullopt if
  /// one of the files has no such pair.
  std::optional<PairError> pair;
  Diagnostics diagnostics;
};

/// Reads the reference of a request.
[[nodiscard]] ReferenceFile read_reference(const CompareRequest& request, Files& files);
/// Compares one file with the reference, which must have a calibration.
[[nodiscard]] ComparedFile compare(const CompareRequest& request, const ReferenceFile& reference, const std::string& file,
                                   Files& files);

struct CompareResult {
  Status status = Status::kDone;
  ReferenceFile reference;
  std::vector<ComparedFile> files;  ///< Empty if the reference cannot be read.
};
/// Reads the reference and compares each of the request's files with it.
[[nodiscard]] CompareResult compare(const CompareRequest& request, Files& files);

/// True if the inverse polynomials of the two files differ by more pixels than their camera models do.
[[nodiscard]] bool inverses_differ(const ComparedFile& compared);

}  // namespace fca
