// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ds.h>

#include "../exact_steps.h"
#include "../ucm/unified.h"

#include <fca/models/ucm.h>

#include <array>

namespace fca {

namespace {

std::optional<Intrinsics<Ucm>> as_ucm(const Intrinsics<Ds>& ds) {
  const auto& [fx, fy, cx, cy, alpha, xi] = ds.values;
  if (xi == 0.0) return Intrinsics<Ucm>{{fx, fy, cx, cy, alpha}};
  if (alpha == 0.0 && xi > 0.0) return internal::unified({fx, fy, cx, cy}, xi);
  return std::nullopt;
}

}  // namespace

std::span<const internal::ExactStep> Ds::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<internal::widened<Ucm, Ds>>(),  // xi = 0
      internal::exact_step<as_ucm>(),
  };
  return kSteps;
}

}  // namespace fca
