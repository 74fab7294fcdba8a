// SPDX-License-Identifier: BSD-3-Clause
// Fits a model to a camera over a field of view. If the model cannot describe the whole field of view, the fit covers the
// largest angle from the axis that it can describe.
#pragma once

#include "../evaluation/stages.h"
#include "fit_model.h"

#include <fca/convert/convert.h>
#include <fca/convert/field_of_view.h>

#include <chrono>
#include <cstddef>
#include <numbers>
#include <optional>

namespace fca::internal {

/// The input of a fit of the model `target` to the rays of `camera`. The object refers to its members, which must outlive it.
struct FitTask {
  const Camera& camera;
  const ModelInfo& target;
  const ConvertOptions& options;
  const FieldOfView& field_of_view;
  LensCentre centre;  ///< Central focal lengths and principal point of the camera.
};

/// A fit to samples of a field of view.
struct SampledFit {
  std::optional<FittedModel> model;  ///< nullopt if no start led to a camera, or there were too few samples.
  std::size_t samples = 0;           ///< The number of samples that weigh more than black (WeightedSamples::counted).
  /// The samples are within this angle from the axis; pi if they cover the whole field of view.
  double max_angle_rad = std::numbers::pi;
};

/// The fit that a conversion reports.
struct FieldOfViewFit {
  SampledFit fitted;
  Score score;  ///< The errors on the evaluation's lattice; empty if there is no model.
  /// The rms [px] over the image with the weights that the fit minimises. It is that of `score` if all pixels weigh the same.
  double rms_px = 0.0;
  std::chrono::duration<double, std::micro> time{};  ///< The time of all fits that led to this one.
};

/// True if the samples give fewer equations (two each) than the target has parameters.
[[nodiscard]] bool too_few(std::size_t samples, const ModelInfo& target);

/// Fits the target to the field of view. If the target does not describe the whole field of view, the result is a fit up to the
/// largest angle from the axis that the target describes. Without options.reduce_angle, the result then has no model.
///
/// The fit uses options.samples samples. It doubles their number, at most three times, while the error over the image differs
/// from that on the samples and more samples help.
///
/// A fit describes a field of view, whole or up to an angle, under these conditions:
/// - A perspective model (pinhole, radtan, rational) must have a pixel for every ray and an rms of at most 1 px. The error of
///   such a model grows without limit towards 90 degrees, so that a fit up to a larger angle would be worse everywhere. If the
///   model has a coefficient that may make its radius shrink (k3 of radtan), the fit must also be at least as good as the fit
///   without this coefficient, inside the angle of the latter.
/// - Every other model must have a pixel for every ray, with any error. Nearly every fit of such a model has one. A limit for
///   the error would give up parts of a lens that the user may need: the user decides which part of the image is lens and which
///   is black corner (ConvertOptions::max_angle_rad). The angle becomes smaller only if no fit reaches the edge (ucm for the
///   black corners of a T265, 123 degrees from the axis).
/// A wider field of view therefore never leads to a fit that covers less of the image: an angle that the target describes
/// inside one field of view is also described inside every larger one. Angles are whole degrees. If the target describes no
/// angle of at least 5 degrees, the fit covers the largest angle for which it has a pixel for every ray.
[[nodiscard]] FieldOfViewFit fit_field_of_view(const FitTask& task);

}  // namespace fca::internal
