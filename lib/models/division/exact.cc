// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/division.h>

#include "../exact_steps.h"

#include <fca/models/eucm.h>
#include <fca/models/pinhole.h>

#include <array>

namespace fca {

namespace {

std::optional<Intrinsics<Eucm>> as_eucm(const Intrinsics<Division>& division) {
  const auto& [fx, fy, cx, cy, k] = division.values;
  if (!(k < 0.0)) return std::nullopt;
  return Intrinsics<Eucm>{{fx, fy, cx, cy, 0.5, -4.0 * k}};
}

std::optional<Intrinsics<Division>> from_eucm(const Intrinsics<Eucm>& eucm) {
  const auto& [fx, fy, cx, cy, alpha, beta] = eucm.values;
  if (alpha != 0.5) return std::nullopt;
  return Intrinsics<Division>{{fx, fy, cx, cy, -0.25 * beta}};
}

}  // namespace

std::span<const internal::ExactStep> Division::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<internal::widened<Pinhole, Division>>(),
      internal::exact_step<internal::narrowed<Division, Pinhole>>(),
      internal::exact_step<as_eucm>(),
      internal::exact_step<from_eucm>(),
  };
  return kSteps;
}

}  // namespace fca
