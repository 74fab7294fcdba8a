// SPDX-License-Identifier: BSD-3-Clause
// Conversions that rotate the camera.
#pragma once

#include "fitting/degree.h"

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// Replaces a fit by one that also rotates the camera, if its rms is smaller and it covers as much of the image; otherwise adds
/// a diagnostic. The new fit has no proven error bound: bounds exist only for a source and a target with the same axes.
void absorb_turn(const FitTask& task, const DegreeFit& fit, Conversion& conversion, Diagnostics& diagnostics);

/// An estimate of the fit with a rotation, if `rms_px`, the rms of the fit without one, is at least 0.02 px and a rotation
/// would make it at least 20 % smaller; otherwise nullopt.
[[nodiscard]] std::optional<TurnOffer> offered_turn(const FitTask& task, const DegreeFit& fit, double rms_px);

}  // namespace fca::internal
