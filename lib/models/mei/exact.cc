// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/mei.h>

#include "../exact_steps.h"
#include "../ucm/unified.h"

#include <fca/models/radtan.h>
#include <fca/models/ucm.h>

#include <array>

namespace fca {

namespace {

std::optional<Intrinsics<Mei>> from_radtan(const Intrinsics<Radtan>& radtan) {
  const auto& [fx, fy, cx, cy, k1, k2, p1, p2, k3] = radtan.values;
  if (k3 != 0.0) return std::nullopt;
  return Intrinsics<Mei>{{fx, fy, cx, cy, 0.0, k1, k2, p1, p2}};
}

std::optional<Intrinsics<Radtan>> as_radtan(const Intrinsics<Mei>& mei) {
  const auto& [fx, fy, cx, cy, xi, k1, k2, p1, p2] = mei.values;
  if (xi != 0.0) return std::nullopt;
  return Intrinsics<Radtan>{{fx, fy, cx, cy, k1, k2, p1, p2, 0.0}};
}

std::optional<Intrinsics<Mei>> from_ucm(const Intrinsics<Ucm>& ucm) {
  const auto& [fx, fy, cx, cy, alpha] = ucm.values;
  if (!(alpha < 1.0)) return std::nullopt;
  return Intrinsics<Mei>{{fx / (1.0 - alpha), fy / (1.0 - alpha), cx, cy, alpha / (1.0 - alpha), 0, 0, 0, 0}};
}

std::optional<Intrinsics<Ucm>> as_ucm(const Intrinsics<Mei>& mei) {
  const auto& [fx, fy, cx, cy, xi, k1, k2, p1, p2] = mei.values;
  if (!internal::all_zero(std::array{k1, k2, p1, p2})) return std::nullopt;
  return internal::unified({fx, fy, cx, cy}, xi);
}

}  // namespace

std::span<const internal::ExactStep> Mei::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<from_radtan>(),
      internal::exact_step<as_radtan>(),
      internal::exact_step<from_ucm>(),
      internal::exact_step<as_ucm>(),
  };
  return kSteps;
}

}  // namespace fca
