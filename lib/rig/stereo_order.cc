// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/stereo_order.h>

#include <cmath>

namespace fca {

std::optional<double> second_left_of_first(const Rig& rig) {
  if (rig.cameras.size() < 2) return std::nullopt;
  const std::optional<Transform> T_c1_c2 = rig.resolve(rig.cameras[0].name, rig.cameras[1].name);
  if (!T_c1_c2) return std::nullopt;
  const double right = (*T_c1_c2)(0, 3);
  constexpr double kMoreAboveThanBeside = 0.98;  // at 45 degrees, both
  if (right >= 0.0 || std::abs(right) < kMoreAboveThanBeside * std::abs((*T_c1_c2)(1, 3))) return std::nullopt;
  return -right;
}

}  // namespace fca
