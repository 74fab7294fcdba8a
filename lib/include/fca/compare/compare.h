// SPDX-License-Identifier: BSD-3-Clause
// Two rigs: pixels, angles, the best rotation between cameras, poses, IMUs and times; and which common mistake explains it.
#pragma once

#include <fca/compare/report.h>
#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <optional>

namespace fca {

struct CompareOptions {
  std::optional<double> max_angle_rad = {};  ///< What counts as lens, from the reference's axis; default: the whole image.
  bool every_pixel = false;                  ///< Score each pixel of the image instead of a lattice.
  bool bound = true;                         ///< Prove ErrorSummary::bound.
  bool by_order = false;                     ///< Cameras are matched by their order, whatever their names.
  /// (0, pi]: the best rotation is sought, and the verdict made, from rays up to that angle from the reference's axis; the
  /// errors over the whole field of view are reported all the same (CameraComparison::focus). Nothing: from the whole field of
  /// view.
  std::optional<double> focus_rad = {};
  /// > 0: points are so far from the reference's projection centre, and a translation is sought with the best rotation
  /// (BestRotation). Nothing: points are infinitely far, and there is only a rotation.
  std::optional<double> distance_m = {};
};

/// How `other` differs from `reference`: a pixel of the reference, its ray by the reference, and the other's pixel of that ray,
/// over the field of view that a conversion of the reference would have: so compare(A, convert(A)) is the conversion's report.
/// Images of another size with the same proportions are scaled (image_change.h); a size that only one specifies holds for both,
/// and where none does, that of the image whose middle is the reference's principal point (CameraComparison::size_assumed).
/// Errors: sizes of other proportions, parameters that are no camera, no pixel in common.
[[nodiscard]] std::optional<CameraComparison> compare(const Camera& reference, const Camera& other,
                                                      const CompareOptions& options, Diagnostics& diagnostics);

/// The same of all that two rigs say. Cameras and IMUs are matched by name; by order where they have no name in common. What
/// could not be compared is an error in `diagnostics`, and left out; nothing at all in common is an error, too. Poses are those
/// of each camera in each IMU and further frame, and of neighbouring cameras, as each rig resolves them.
[[nodiscard]] RigComparison compare(const Rig& reference, const Rig& other, const CompareOptions& options,
                                    Diagnostics& diagnostics);

}  // namespace fca
