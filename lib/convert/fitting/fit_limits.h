// SPDX-License-Identifier: BSD-3-Clause
// The ranges of a model's parameters in a fit, and the parameters that the fit must not change.
#pragma once

#include <fca/convert/fit_target.h>

#include <array>
#include <span>

namespace fca::internal {

struct FitLimits {
  ParameterValues lower{};
  ParameterValues upper{};
  /// True if fits of the model leave the parameter at its start (FitTarget::held), and `ranges` has no range for it.
  std::array<bool, kMostParameters> held{};

  /// Begins with the model's own ranges and narrows them by `ranges`.
  FitLimits(const FitTarget& target, std::span<const ParameterRange> ranges);

  /// True if a fit cannot change the parameter: it is held, or its range is one value.
  [[nodiscard]] bool fixed(std::size_t i) const { return held[i] || lower[i] == upper[i]; }
};

}  // namespace fca::internal
