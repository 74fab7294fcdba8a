// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/eucm.h>

#include "../exact_steps.h"

#include <fca/models/pinhole.h>
#include <fca/models/ucm.h>

#include <array>

namespace fca {

namespace {

std::optional<Intrinsics<Eucm>> from_ucm(const Intrinsics<Ucm>& ucm) {
  const auto& [fx, fy, cx, cy, alpha] = ucm.values;
  return Intrinsics<Eucm>{{fx, fy, cx, cy, alpha, 1.0}};
}

std::optional<Intrinsics<Ucm>> as_ucm(const Intrinsics<Eucm>& eucm) {
  const auto& [fx, fy, cx, cy, alpha, beta] = eucm.values;
  if (beta != 1.0) return std::nullopt;
  return Intrinsics<Ucm>{{fx, fy, cx, cy, alpha}};
}

/// Without alpha beta counts for nothing.
std::optional<Intrinsics<Pinhole>> as_pinhole(const Intrinsics<Eucm>& eucm) {
  const auto& [fx, fy, cx, cy, alpha, beta] = eucm.values;
  if (alpha != 0.0) return std::nullopt;
  return Intrinsics<Pinhole>{{fx, fy, cx, cy}};
}

}  // namespace

std::span<const internal::ExactStep> Eucm::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<from_ucm>(),
      internal::exact_step<as_ucm>(),
      internal::exact_step<as_pinhole>(),
  };
  return kSteps;
}

}  // namespace fca
