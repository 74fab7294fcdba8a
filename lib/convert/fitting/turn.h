// SPDX-License-Identifier: BSD-3-Clause
// Fits a rotation of the camera together with its model. What a model cannot represent of a lens (tangential terms, an affine
// part) is mostly a tilt of its axis, which a pose can represent.
#pragma once

#include "fit_model.h"

#include <fca/rig/transform.h>

#include <optional>
#include <span>

namespace fca::internal {

struct TurnedFit {
  FittedModel fitted;
  Transform T_target_source;  ///< A rotation; takes rays of the source to rays of the target.
};

/// Finds the best fit with a rotation, starting from the best one without. Gauss-Newton steps change the angles; after each the
/// model is fitted again to the rotated rays (variable projection: Golub & Pereyra 1973). nullopt if no step improves the rms.
[[nodiscard]] std::optional<TurnedFit> fit_with_turn(const FittedModel& start, std::span<const Correspondence> samples,
                                                     std::span<const ParameterRange> ranges);

/// An estimate of what fit_with_turn() would reach, from its first step.
struct TurnEstimate {
  double rms_px = 0.0;
  double angle_rad = 0.0;
};
[[nodiscard]] std::optional<TurnEstimate> estimate_turn(const FittedModel& fitted, std::span<const Correspondence> samples,
                                                        std::span<const ParameterRange> ranges);

}  // namespace fca::internal
