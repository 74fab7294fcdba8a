// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ftheta.h>

#include "../exact_steps.h"

#include <fca/models/woodscape.h>

#include <array>

namespace fca {

namespace {

/// Of rho in pixels of u, that in pixels of v.
std::optional<Intrinsics<Ftheta>> from_woodscape(const Intrinsics<Woodscape>& woodscape) {
  const auto& [k1, k2, k3, k4, aspect, cx, cy] = woodscape.values;
  return Intrinsics<Ftheta>{{k1 * aspect, k2 * aspect, k3 * aspect, k4 * aspect, 0.0, 1.0 / aspect, 0.0, 0.0, cx, cy}};
}

std::optional<Intrinsics<Woodscape>> as_woodscape(const Intrinsics<Ftheta>& ftheta) {
  const auto& [k1, k2, k3, k4, k5, c, d, e, cx, cy] = ftheta.values;
  if (!internal::all_zero(std::array{k5, d, e})) return std::nullopt;
  return Intrinsics<Woodscape>{{k1 * c, k2 * c, k3 * c, k4 * c, 1.0 / c, cx, cy}};
}

}  // namespace

std::span<const internal::ExactStep> Ftheta::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<from_woodscape>(),
      internal::exact_step<as_woodscape>(),
  };
  return kSteps;
}

}  // namespace fca
