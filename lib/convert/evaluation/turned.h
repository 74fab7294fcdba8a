// SPDX-License-Identifier: BSD-3-Clause
// Evaluates fits that also rotate the camera.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/report.h>
#include <fca/models/camera_model.h>
#include <fca/rig/transform.h>

namespace fca::internal {

/// The errors of `target` if `T_target_source` first rotates the source's rays. `max_angle_rad`: as for Scorer. `every_pixel`:
/// as in EvaluateOptions. The result has no bound: bounds are proven only for a source and a target with the same axis.
[[nodiscard]] ErrorStatistics evaluate_turned(const CameraModel& source, const CameraModel& target,
                                              const Transform& T_target_source, const FieldOfView& field_of_view,
                                              double max_angle_rad, bool every_pixel);

/// True if the scored share of the image is at most 1e-3 smaller in `after` than in `before`.
[[nodiscard]] bool covers_as_much(const ErrorStatistics& before, const ErrorStatistics& after);

}  // namespace fca::internal
