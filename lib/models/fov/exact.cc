// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/fov.h>

#include "../exact_steps.h"

#include <fca/models/kb4.h>

#include <array>
#include <cmath>
#include <limits>

namespace fca {

namespace {

/// The w at which atan2(2 r tan(w / 2), z) is the angle itself.
double equidistant_w() { return 2.0 * std::atan(0.5); }

std::optional<Intrinsics<Fov>> from_kb4(const Intrinsics<Kb4>& kb4) {
  const auto& [fx, fy, cx, cy, k1, k2, k3, k4] = kb4.values;
  if (!internal::all_zero(std::array{k1, k2, k3, k4})) return std::nullopt;
  const double w = equidistant_w();
  return Intrinsics<Fov>{{fx * w, fy * w, cx, cy, w}};
}

std::optional<Intrinsics<Kb4>> as_kb4(const Intrinsics<Fov>& fov) {
  const auto& [fx, fy, cx, cy, w] = fov.values;
  if (!(std::abs(w - equidistant_w()) <= std::numeric_limits<double>::epsilon())) return std::nullopt;
  return Intrinsics<Kb4>{{fx / w, fy / w, cx, cy, 0.0, 0.0, 0.0, 0.0}};
}

}  // namespace

std::span<const internal::ExactStep> Fov::exact_steps() {
  static constexpr std::array kSteps = {
      internal::exact_step<from_kb4>(),
      internal::exact_step<as_kb4>(),
  };
  return kSteps;
}

}  // namespace fca
