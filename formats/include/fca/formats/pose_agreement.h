// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rig/transform.h>

#include <algorithm>
#include <cmath>

namespace fca {

/// Do two transforms differ by no more than rounding?
[[nodiscard]] inline bool agree(const Transform& a, const Transform& b) {
  constexpr double kRounding = 1e-12;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (!(std::abs(a.values[i] - b.values[i]) <= kRounding * std::max(1.0, std::abs(b.values[i])))) return false;
  }
  return true;
}

}  // namespace fca
