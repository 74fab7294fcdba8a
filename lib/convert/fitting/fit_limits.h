// SPDX-License-Identifier: BSD-3-Clause
// Which parameters of a model a fit may change, and how far.
#pragma once

#include <fca/convert/fit_target.h>

#include <array>
#include <span>

namespace fca::internal {

struct FitLimits {
  ParameterValues lower{};
  ParameterValues upper{};
  std::array<bool, kMostParameters> held{};  ///< True if a fit never changes the parameter, whatever its bounds.

  /// Takes the model's own ranges and narrows them by `ranges`.
  FitLimits(const FitTarget& target, std::span<const ParameterRange> ranges);

  /// True if a fit cannot change the parameter: it is held, or its range is one value.
  [[nodiscard]] bool fixed(std::size_t i) const { return held[i] || lower[i] == upper[i]; }
};

}  // namespace fca::internal
