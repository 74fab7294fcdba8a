// SPDX-License-Identifier: BSD-3-Clause
// Fits a camera as another model over a field of view: the whole field of view or, where the target cannot describe that, the
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

/// The input of a fit: `camera` is fitted as the model `target`.
struct FitTask {
  const Camera& camera;
  const ModelInfo& target;
  const ConvertOptions& options;
  const FieldOfView& field_of_view;
  LensCentre centre;  ///< Focal lengths and principal point of the camera.
};

/// A fit, its number of samples, and the angle from the axis up to which it is valid.
struct SampledFit {
  std::optional<FittedModel> model;  ///< nullopt if no start led to a camera, or there are too few samples.
  std::size_t samples = 0;
  double max_angle_rad = std::numbers::pi;  ///< From the axis: what was fitted; pi if it was the whole field of view.
};

/// The fit that a conversion reports, its error on the lattice, and the time of the search.
struct FieldOfViewFit {
  SampledFit fitted;
  Score score;          ///< Empty without a model.
  double rms_px = 0.0;  ///< The rms over the image that the fit minimises: that of `score`, or weighted by the options' weight.
  std::chrono::duration<double, std::micro> time{};
};

/// True if the samples give fewer equations (two each) than the target has parameters.
[[nodiscard]] bool too_few(std::size_t samples, const ModelInfo& target);

/// Fits the target to the field of view. If it does not describe the whole field of view, the result is a fit up to a smaller
/// angle from the axis or, without options.reduce_angle, has no model.
///
/// Fits to options.samples samples. Doubles their number while the error over the image differs from that on the samples and
/// more samples help.
///
/// "Describes" means the same for the whole field of view and for a smaller angle, of which the largest described one is taken:
/// - A perspective model (pinhole, radtan, rational) must have a pixel for every ray and an rms of at most
///   1 px. Its error grows without limit towards 90 degrees, so that beyond some angle it would spoil the whole fit for the
///   sake of the edge. If it has a coefficient that may bend its radius back (radtan's k3), it must also be at least as good as
///   the fit without that coefficient, inside that fit's angle.
/// - Every other model must have a pixel for every ray, at any error. Nearly always a fit of it has one, and a limit on the
///   error would give up parts of a lens that the user may need: the user decides what is lens and what is black corner
///   (ConvertOptions::max_angle_rad). A smaller angle is taken only if no fit reaches the edge (ucm on a T265's black corners,
///   123 degrees from the axis).
/// A wider field of view therefore never covers less of the image: an angle described inside one field of view is also
/// described inside every larger one. Angles are whole degrees. If no angle of at least 5 degrees is described, the largest
/// with a pixel for every ray is taken.
[[nodiscard]] FieldOfViewFit fit_field_of_view(const FitTask& task);

}  // namespace fca::internal
