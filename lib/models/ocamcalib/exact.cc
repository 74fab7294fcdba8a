// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/ocamcalib.h>

#include "../exact_steps.h"

#include <fca/models/pinhole.h>
#include <fca/models/ucm.h>

#include <array>

namespace fca {

namespace {

std::optional<Intrinsics<Ocamcalib>> from_pinhole(const Intrinsics<Pinhole>& pinhole) {
  const auto& [fx, fy, cx, cy] = pinhole.values;
  return Intrinsics<Ocamcalib>{{cx, cy, fy / fx, 0, 0, -fx, 0, 0, 0, 0, 0, 0, 0, 0}};
}

/// A ray ahead is at the height -a0 over the image, whatever its radius.
std::optional<Intrinsics<Pinhole>> as_pinhole(const Intrinsics<Ocamcalib>& ocamcalib) {
  const auto& [cx, cy, c, d, e, a0, a1, a2, a3, a4, a5, a6, a7, a8] = ocamcalib.values;
  if (!internal::all_zero(std::array{d, e, a1, a2, a3, a4, a5, a6, a7, a8})) return std::nullopt;
  return Intrinsics<Pinhole>{{-a0, -a0 * c, cx, cy}};
}

/// Stereographic, r = 2 f tan(angle / 2): the ray's height over the radius is f - r^2 / (4 f).
std::optional<Intrinsics<Ocamcalib>> from_stereographic(const Intrinsics<Ucm>& ucm) {
  const auto& [fx, fy, cx, cy, alpha] = ucm.values;
  if (alpha != 0.5) return std::nullopt;
  return Intrinsics<Ocamcalib>{{cx, cy, fy / fx, 0, 0, -fx, 0, 0.25 / fx, 0, 0, 0, 0, 0, 0}};
}

}  // namespace

std::span<const internal::ExactStep> Ocamcalib::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<from_pinhole>(),
      internal::exact_step<as_pinhole>(),
      internal::exact_step<from_stereographic>(),
  };
  return kSteps;
}

}  // namespace fca
