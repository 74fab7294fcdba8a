// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/thin_prism_fisheye.h>

#include "../exact_steps.h"

#include <fca/models/kb4.h>

#include <array>

namespace fca {

namespace {

std::optional<Intrinsics<ThinPrismFisheye>> from_kb4(const Intrinsics<Kb4>& kb4) {
  const auto& [fx, fy, cx, cy, k1, k2, k3, k4] = kb4.values;
  return Intrinsics<ThinPrismFisheye>{{fx, fy, cx, cy, k1, k2, 0.0, 0.0, k3, k4, 0.0, 0.0}};
}

std::optional<Intrinsics<Kb4>> as_kb4(const Intrinsics<ThinPrismFisheye>& model) {
  const auto& [fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, sx1, sy1] = model.values;
  if (!internal::all_zero(std::array{p1, p2, sx1, sy1})) return std::nullopt;
  return Intrinsics<Kb4>{{fx, fy, cx, cy, k1, k2, k3, k4}};
}

}  // namespace

std::span<const internal::ExactStep> ThinPrismFisheye::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<from_kb4>(),
      internal::exact_step<as_kb4>(),
  };
  return kSteps;
}

}  // namespace fca
