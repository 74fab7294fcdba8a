// SPDX-License-Identifier: BSD-3-Clause
// Comparing transforms in tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fca/rig/transform.h"

namespace fca::test {

/// The largest difference between elements at the same place of two 4 x 4 matrices.
inline double element_difference(const Transform& a, const Transform& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) worst = std::max(worst, std::abs(a.values[i] - b.values[i]));
  return worst;
}

}  // namespace fca::test
