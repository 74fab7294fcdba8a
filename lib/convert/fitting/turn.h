// SPDX-License-Identifier: BSD-3-Clause
// Fits a rotation of the camera together with its model. Most of the effect of tangential terms, or of an affine part, is a
// tilt of the optical axis. A model without such terms cannot represent it, but the camera's pose can.
#pragma once

#include "fit_model.h"

#include <fca/rig/transform.h>

#include <optional>
#include <span>

namespace fca::internal {

/// A fit to rotated rays.
struct TurnedFit {
  FittedModel fitted;
  Transform T_target_source;  ///< The rotation, which transforms rays of the source to rays of the target.
};

/// Finds the best fit with a rotation, starting from the best fit without one. Gauss-Newton steps change the rotation. After
/// each step the model is fitted again to the rotated rays (variable projection: Golub & Pereyra 1973). nullopt if no step
/// reduces the rms.
[[nodiscard]] std::optional<TurnedFit> fit_with_turn(const FittedModel& start, std::span<const Correspondence> samples,
                                                     std::span<const ParameterRange> ranges);

/// An estimate of the result of fit_with_turn(): that of its first step, if the errors were linear.
struct TurnEstimate {
  double ratio = 1.0;      ///< The rms over that of a step of the parameters alone, on the same samples.
  double angle_rad = 0.0;  ///< The angle of the rotation.
};
/// nullopt if the ratio is not less than `largest_ratio`, a sample has no pixel, or the first step has no solution.
[[nodiscard]] std::optional<TurnEstimate> estimate_turn(const FittedModel& fitted, std::span<const Correspondence> samples,
                                                        std::span<const ParameterRange> ranges, double largest_ratio);

}  // namespace fca::internal
