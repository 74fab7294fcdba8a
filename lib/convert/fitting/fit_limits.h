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
  std::array<bool, kMostParameters> held{};  ///< Stays where a fit begins, whatever its bounds.

  /// The model's own ranges, narrowed by `ranges`.
  FitLimits(const FitTarget& target, std::span<const ParameterRange> ranges);

  /// Nothing to change: held, or a range of one number.
  [[nodiscard]] bool fixed(std::size_t i) const { return held[i] || lower[i] == upper[i]; }
};

}  // namespace fca::internal
