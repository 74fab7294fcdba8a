// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

namespace fca::internal {

/// x / (z + xi d) = (x / (1 + xi)) / ((1 - alpha) z + alpha d) with alpha = xi / (1 + xi), d the ray's length.
inline Intrinsics<Ucm> unified(const Intrinsics<Pinhole>& focal, double xi) {
  const auto& [fx, fy, cx, cy] = focal.values;
  return {{fx / (1.0 + xi), fy / (1.0 + xi), cx, cy, xi / (1.0 + xi)}};
}

}  // namespace fca::internal
