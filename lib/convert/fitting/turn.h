// SPDX-License-Identifier: BSD-3-Clause
// A turn of the camera fitted together with its model: what a model cannot hold of a lens (tangential terms, an affine part) is
// mostly a tilt of its axis, and a pose can hold that.
#pragma once

#include "fit_model.h"

#include <fca/rig/transform.h>

#include <optional>
#include <span>

namespace fca::internal {

struct TurnedFit {
  FittedModel fitted;
  Transform T_target_source;  ///< A rotation.
};

/// From the best fit without a turn to the best one with it: Gauss-Newton steps of the angles along which the other parameters
/// follow (variable projection: Golub & Pereyra 1973), each with the model refitted to the turned rays. Nothing where no step
/// is better.
[[nodiscard]] std::optional<TurnedFit> fit_with_turn(const FittedModel& start, std::span<const Correspondence> samples,
                                                     std::span<const ParameterRange> ranges);

/// What fit_with_turn() would come to by its first step, without it.
struct TurnEstimate {
  double rms_px = 0.0;
  double angle_rad = 0.0;
};
[[nodiscard]] std::optional<TurnEstimate> estimate_turn(const FittedModel& fitted, std::span<const Correspondence> samples,
                                                        std::span<const ParameterRange> ranges);

}  // namespace fca::internal
