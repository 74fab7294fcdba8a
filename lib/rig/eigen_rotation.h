// SPDX-License-Identifier: BSD-3-Clause
// Rotations as Eigen's matrices, for code that computes with them. Public headers show no Eigen.
#pragma once

#include <fca/rig/transform.h>

#include <Eigen/Geometry>

namespace fca::internal {

[[nodiscard]] inline Transform transform_of(const Eigen::Matrix3d& R) {
  Transform T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = R(row, column);
  }
  return T;
}

/// Its 3 x 3 part.
[[nodiscard]] inline Eigen::Matrix3d matrix_of(const Transform& T) {
  Eigen::Matrix3d R;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) R(row, column) = T(row, column);
  }
  return R;
}

/// About the vector, by its length [rad].
[[nodiscard]] inline Eigen::Matrix3d rotation_by(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
}

}  // namespace fca::internal
