// SPDX-License-Identifier: BSD-3-Clause
// A turn of the camera as a part of its conversion.
#pragma once

#include "fitting/degree.h"

#include <fca/convert/convert.h>

#include <optional>

namespace fca::internal {

/// Replaces a fit by one that a turn of the camera is a part of, if that is better and reaches as much; else says so. A bound
/// of the error is proven for cameras with one axis only: there is none.
void absorb_turn(const FitTask& task, const DegreeFit& fit, Conversion& conversion, Diagnostics& diagnostics);

/// What a turn would come to, about, where it would make a visible error a fifth smaller. `rms_px`: that error.
[[nodiscard]] std::optional<TurnOffer> offered_turn(const FitTask& task, const DegreeFit& fit, double rms_px);

}  // namespace fca::internal
