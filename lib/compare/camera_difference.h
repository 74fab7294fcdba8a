// SPDX-License-Identifier: BSD-3-Clause
// Two camera models over a field of view: the error statistics, in pixels and in degrees.
#pragma once

#include <fca/compare/report.h>
#include <fca/convert/evaluate.h>
#include <fca/convert/field_of_view.h>
#include <fca/models/camera_model.h>

#include <optional>

namespace fca::internal {

/// Two models; the reference's rays are turned by `T_other_reference` if there is one. With a distance its points, so far from
/// the reference's projection centre, are moved by it.
struct ModelPair {
  const CameraModel& reference;
  const CameraModel& other;
  const Transform* T_other_reference = nullptr;
  std::optional<double> distance_m = {};
};

[[nodiscard]] CameraDifference difference_of(const ModelPair& pair, const FieldOfView& field_of_view,
                                             const EvaluateOptions& options);

/// The root mean square of the errors [px] in which a pixel that the other does not have counts as wrong by the image's
/// diagonal: one number to choose among explanations.
[[nodiscard]] double misfit_px(const CameraModel& reference, const CameraModel& other, const FieldOfView& field_of_view);

}  // namespace fca::internal
