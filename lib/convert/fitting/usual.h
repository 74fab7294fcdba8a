// SPDX-License-Identifier: BSD-3-Clause
// Fits whose parameters stay where those of published cameras lie, if that costs next to nothing.
#pragma once

#include "fit_domain.h"

#include <fca/convert/report.h>

#include <vector>

namespace fca::internal {

struct UsualFit {
  DomainFit fit;
  std::vector<ParameterRange> ranges;     ///< That it was made with.
  std::vector<UnusualParameter> unusual;  ///< What it leaves the usual range with.
};

/// fit_fixed(); where a parameter leaves its usual range (Parameter::usual), which no range of the options mentions, the best
/// fit inside, if its rms is within 1 % of the other's, or nobody sees the difference. Of exact fits it is the lens itself that
/// is unusual: they stay.
[[nodiscard]] UsualFit fit_usual(const FitTask& task);

}  // namespace fca::internal
