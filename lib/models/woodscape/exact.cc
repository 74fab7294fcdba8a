// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/woodscape.h>

#include "../exact_steps.h"

#include <fca/models/kb4.h>

#include <array>

namespace fca {

namespace {

/// A radius of f angle + f k angle^3.
std::optional<Intrinsics<Woodscape>> from_kb4(const Intrinsics<Kb4>& kb4) {
  const auto& [fx, fy, cx, cy, k1, k2, k3, k4] = kb4.values;
  if (!internal::all_zero(std::array{k2, k3, k4})) return std::nullopt;
  return Intrinsics<Woodscape>{{fx, 0.0, fx * k1, 0.0, fy / fx, cx, cy}};
}

std::optional<Intrinsics<Kb4>> as_kb4(const Intrinsics<Woodscape>& woodscape) {
  const auto& [k1, k2, k3, k4, aspect, cx, cy] = woodscape.values;
  if (k2 != 0.0 || k4 != 0.0) return std::nullopt;
  return Intrinsics<Kb4>{{k1, k1 * aspect, cx, cy, k3 / k1, 0.0, 0.0, 0.0}};
}

}  // namespace

std::span<const internal::ExactStep> Woodscape::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<from_kb4>(),
      internal::exact_step<as_kb4>(),
  };
  return kSteps;
}

}  // namespace fca
