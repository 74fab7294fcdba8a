// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/fisheye624.h>

#include "../exact_steps.h"

#include <fca/models/kb4.h>

#include <array>

namespace fca {

namespace {

std::optional<Intrinsics<Fisheye624>> from_kb4(const Intrinsics<Kb4>& kb4) {
  const auto& [fx, fy, cx, cy, k1, k2, k3, k4] = kb4.values;
  return Intrinsics<Fisheye624>{{fx, fy, cx, cy, k1, k2, k3, k4}};
}

std::optional<Intrinsics<Kb4>> as_kb4(const Intrinsics<Fisheye624>& model) {
  const auto& [fx, fy, cx, cy, k0, k1, k2, k3, k4, k5, p0, p1, s0, s1, s2, s3] = model.values;
  if (!internal::all_zero(std::array{k4, k5, p0, p1, s0, s1, s2, s3})) return std::nullopt;
  return Intrinsics<Kb4>{{fx, fy, cx, cy, k0, k1, k2, k3}};
}

}  // namespace

std::span<const internal::ExactStep> Fisheye624::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<from_kb4>(),
      internal::exact_step<as_kb4>(),
  };
  return kSteps;
}

}  // namespace fca
