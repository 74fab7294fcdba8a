// SPDX-License-Identifier: BSD-3-Clause
// Which parameters of a model a fit may change, and how far.
#pragma once

#include <fca/convert/convert.h>
#include <fca/models/model_traits.h>

#include <algorithm>
#include <array>
#include <span>

namespace fca::internal {

template <CameraModelType M>
struct Limits {
  std::array<double, kParameterCount<M>> lower{};
  std::array<double, kParameterCount<M>> upper{};
  std::array<bool, kParameterCount<M>> held{};  ///< Stays where a fit begins, whatever its bounds.

  /// Nothing to change: held, or a range of one number.
  [[nodiscard]] bool fixed(std::size_t i) const { return held[i] || lower[i] == upper[i]; }
};

/// The model's own ranges, narrowed by `ranges`.
template <CameraModelType M>
Limits<M> limits_of(std::span<const ParameterRange> ranges) {
  Limits<M> limits;
  for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
    const Parameter& p = M::kParameters[i];
    // An open end of a model's range is not a camera, but what lies next to it may be the best one: eucm with beta -> 0 is
    // how a pinhole looks where alpha must be above 0.5.
    constexpr double kHair = 1e-6;
    limits.lower[i] = p.lower + (p.open ? kHair : 0.0);
    limits.upper[i] = p.upper - (p.open ? kHair : 0.0);
    limits.held[i] = held_in_fits<M>(p.name);
    for (const ParameterRange& range : ranges) {
      if (range.parameter != p.name) continue;
      limits.held[i] = false;
      limits.lower[i] = std::max(limits.lower[i], range.lower);
      limits.upper[i] = std::min(limits.upper[i], range.upper);
    }
  }
  return limits;
}

}  // namespace fca::internal
