// SPDX-License-Identifier: BSD-3-Clause
// Evaluates fits in which the camera was turned.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/report.h>
#include <fca/models/camera_model.h>
#include <fca/rig/transform.h>

namespace fca::internal {

/// Compares `target` with the source, whose rays `T_target_source` turns first. The result has no bound: bounds are proven only
/// for a source and a target with the same axes.
[[nodiscard]] ErrorStatistics evaluate_turned(const CameraModel& source, const CameraModel& target,
                                              const Transform& T_target_source, const FieldOfView& field_of_view,
                                              double max_angle_rad, bool every_pixel);

/// True if the scored share of the image after a change is at most 1e-3 smaller than before.
[[nodiscard]] bool reaches_as_much(const ErrorStatistics& before, const ErrorStatistics& after);

}  // namespace fca::internal
