// SPDX-License-Identifier: BSD-3-Clause
// One camera fitted as another model over a domain: the whole of it or, where the target cannot describe that, the largest cone
// around the axis on which it can.
#pragma once

#include "../evaluation/stages.h"
#include "fit_model.h"

#include <fca/convert/convert.h>
#include <fca/convert/domain.h>

#include <chrono>
#include <cstddef>
#include <numbers>
#include <optional>

namespace fca::internal {

/// What is fitted to what.
struct FitTask {
  const Camera& camera;
  const ModelInfo& target;
  const ConvertOptions& options;
  const Domain& domain;
  LensCentre centre;  ///< Of the camera.
};

/// A fit, the number of samples it was made on, and the angle up to which it counts.
struct SampledFit {
  std::optional<FittedModel> model;  ///< Nothing where no start led to a camera, or the samples are too few for one.
  std::size_t samples = 0;
  double reach_rad = std::numbers::pi;  ///< A cone's angle; pi where the whole domain was fitted.
};

/// The fit that a conversion reports, what the judge's lattice says of it, and how long the search took.
struct DomainFit {
  SampledFit fitted;
  Score score;          ///< Empty without a model.
  double rms_px = 0.0;  ///< What the fit made small, over the image: of `score`, or weighted as the options say.
  std::chrono::duration<double, std::micro> time{};
};

/// Are there too few samples to fit that model?
[[nodiscard]] bool too_few(std::size_t samples, const ModelInfo& target);

/// Without options.cone no model where it does not describe the whole domain.
///
/// Fits on options.samples samples, and on twice as many while the model is worse or better between them and that helps.
///
/// The whole domain or a cone: the largest that the target describes, and "describes" means the same for both.
/// - What sees ahead only (pinhole, radtan, rational) must have a pixel for every ray and stay under 1 px rms: its error grows
///   without limit towards 90 degrees, so that there always is an angle beyond which the whole is spoiled for an edge. With a
///   coefficient that bends its radius back (radtan's k3) it must not be worse, over the cone of the fit without it, than that.
/// - Every other model must have a pixel for every ray, at whatever error: nearly always a fit of it has one, and a limit of
///   the error would give up parts of a lens that the user may need; what is lens and what black corner is the user's to say
///   (ConvertOptions::max_angle_rad). Where no fit was found that reaches the edge (ucm on a T265's black corners, 123 degrees
///   from its axis), that is a cone, at whatever error as well.
/// A wider domain can therefore never score less of the image: a cone that is described inside one angle is there inside every
/// larger one, too. (Cones end at whole degrees; where no cone from 5 degrees on is described, the widest that is reached.)
[[nodiscard]] DomainFit fit_domain(const FitTask& task);

}  // namespace fca::internal
