// SPDX-License-Identifier: BSD-3-Clause
// Fits that keep parameters in the range of published cameras if the rms then increases by almost nothing.
#pragma once

#include "fit_field_of_view.h"

#include <fca/convert/report.h>

#include <vector>

namespace fca::internal {

/// The result of fit_usual().
struct UsualFit {
  FieldOfViewFit fit;
  std::vector<ParameterRange> ranges;     ///< The ranges of this fit.
  std::vector<UnusualParameter> unusual;  ///< The parameters outside their usual range; empty for an rms below 1e-6 px.
};

/// Like fit_fixed(). If a parameter ends outside its usual range (Parameter::usual) and no range of the options fixes it, fits
/// again inside all usual ranges. Returns the second fit if its rms is at most 1 % or 1e-4 px larger than that of the first
/// fit, and it covers as much of the image. A first fit with an rms below 1e-6 px needs no second one: the lens itself is then
/// unusual.
[[nodiscard]] UsualFit fit_usual(const FitTask& task);

}  // namespace fca::internal
