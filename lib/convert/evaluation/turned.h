// SPDX-License-Identifier: BSD-3-Clause
// The judge of a fit that a turn of the camera is a part of.
#pragma once

#include <fca/convert/domain.h>
#include <fca/convert/report.h>
#include <fca/models/camera_model.h>
#include <fca/rig/transform.h>

namespace fca::internal {

/// `target` against the source, whose rays are turned by `T_target_source` first. A bound is proven for cameras with one axis
/// only: there is none.
[[nodiscard]] Judgement judge_turned(const CameraModel& source, const CameraModel& target, const Transform& T_target_source,
                                     const Domain& domain, double reach_rad, bool every_pixel);

/// Is as much of the image scored as before, but for what nobody notices?
[[nodiscard]] bool reaches_as_much(const Judgement& before, const Judgement& after);

}  // namespace fca::internal
