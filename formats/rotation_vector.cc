// SPDX-License-Identifier: BSD-3-Clause
#include "rotation_vector.h"

#include <fca/rig/rotation.h>

#include <cmath>

namespace fca {

void set_rotation(const RotationVector& vector, Transform& T_a_b) {
  const double angle = std::hypot(vector[0], vector[1], vector[2]);
  if (angle == 0.0) return;
  const double axis[3] = {vector[0] / angle, vector[1] / angle, vector[2] / angle};
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    T_a_b(i, i) = c + (1.0 - c) * axis[i] * axis[i];
    T_a_b(i, j) = (1.0 - c) * axis[i] * axis[j] - s * axis[k];
    T_a_b(i, k) = (1.0 - c) * axis[i] * axis[k] + s * axis[j];
  }
}

RotationVector rotation_vector_of(const Transform& T_a_b) {
  const Quaternion q = quaternion_of(T_a_b);
  const double sine = std::hypot(q[0], q[1], q[2]);
  if (sine == 0.0) return {0.0, 0.0, 0.0};
  const double scale = 2.0 * std::atan2(sine, q[3]) / sine;
  return {scale * q[0], scale * q[1], scale * q[2]};
}

}  // namespace fca
