// SPDX-License-Identifier: BSD-3-Clause
// Conversions that rotate the camera.
#pragma once

#include "fitting/degree.h"

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// Makes a fit that also rotates the camera. Replaces the conversion by it if its rms is at least 1 % smaller and it covers as
/// much of the image; otherwise adds a diagnostic. The new fit has no proven error bound: bounds exist only for a source and a
/// target with the same axis.
void absorb_turn(const FitTask& task, const DegreeFit& fit, Conversion& conversion, Diagnostics& diagnostics);

/// The estimated angle and rms of a fit that also rotates the camera. nullopt unless `rms_px`, the rms of the fit without a
/// rotation, is at least 0.02 px and the estimate is more than 20 % smaller.
[[nodiscard]] std::optional<TurnOffer> offered_turn(const FitTask& task, const DegreeFit& fit, double rms_px);

}  // namespace fca::internal
