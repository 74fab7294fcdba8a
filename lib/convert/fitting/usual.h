// SPDX-License-Identifier: BSD-3-Clause
// Fits that keep parameters in the range of published cameras, if that costs nearly nothing.
#pragma once

#include "fit_field_of_view.h"

#include <fca/convert/report.h>

#include <vector>

namespace fca::internal {

struct UsualFit {
  FieldOfViewFit fit;
  std::vector<ParameterRange> ranges;     ///< The ranges of this fit.
  std::vector<UnusualParameter> unusual;  ///< The parameters outside their usual range.
};

/// Like fit_fixed(). If a parameter ends outside its usual range (Parameter::usual) and no range of the options fixes it, fits
/// again inside all usual ranges. Takes that fit if its rms is within 1 % or 1e-4 px of the first one's. A fit with an rms
/// below 1e-6 px is kept, since the lens itself is then unusual.
[[nodiscard]] UsualFit fit_usual(const FitTask& task);

}  // namespace fca::internal
