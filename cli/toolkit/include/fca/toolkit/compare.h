// SPDX-License-Identifier: BSD-3-Clause
// How calibrations of any formats and models differ.
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
  Inputs reference;                    ///< Its camera choice and lens count for the other files, too.
  std::vector<std::string> files;      ///< Each is compared with the reference.
  std::vector<std::string> parts;      ///< Further parts of each of these files; those of the inputs are the reference's.
  std::optional<double> max_error_px;  ///< kRejected if a pixel differs by more.
  bool strict = false;                 ///< kRejected if poses or numbers differ.
  bool every_pixel = false;
  std::optional<double> focus_rad = {};   ///< Rays up to that angle from the axis count (CompareOptions).
  std::optional<double> distance_m = {};  ///< Of the points; nothing: infinite (CompareOptions).
};

/// The reference, as read.
struct ReferenceFile {
  std::string file;
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;
};

/// One file and how it differs.
struct ComparedFile {
  std::string file;
  Status status = Status::kDone;
  std::optional<Calibration> calibration;
  std::optional<RigComparison> comparison;
  /// How far apart [px] two OCamCalib files image the rays of the reference's image by their inverse polynomials (world2cam),
  /// which are no part of the compared model; nothing for other formats and for images of different sizes.
  std::optional<double> inverse_px;
  /// Of the reference's stereo pair, rectified by what the other file says of it; nothing where one of them has none.
  std::optional<PairError> pair;
  Diagnostics diagnostics;
};

[[nodiscard]] ReferenceFile read_reference(const CompareRequest& request, Files& files);
/// `reference` has a calibration.
[[nodiscard]] ComparedFile compare(const CompareRequest& request, const ReferenceFile& reference, const std::string& file,
                                   Files& files);

struct CompareResult {
  Status status = Status::kDone;
  ReferenceFile reference;
  std::vector<ComparedFile> files;  ///< None where the reference cannot be read.
};
[[nodiscard]] CompareResult compare(const CompareRequest& request, Files& files);

/// Is there more between the inverse polynomials than between the directions?
[[nodiscard]] bool inverses_differ(const ComparedFile& compared);

}  // namespace fca
