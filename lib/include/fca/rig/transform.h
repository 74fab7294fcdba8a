// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace fca {

/// A 4 x 4 matrix T_a_b, row-major: takes points in b (homogeneous, metres) to points in a. Kept as it was read: inversion is
/// that of a general affine map, so a slightly non-orthogonal rotation survives there and back.
struct Transform {
  std::array<double, 16> values = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  [[nodiscard]] double operator()(int row, int column) const { return values[static_cast<std::size_t>(4 * row + column)]; }
  [[nodiscard]] double& operator()(int row, int column) { return values[static_cast<std::size_t>(4 * row + column)]; }
  bool operator==(const Transform&) const = default;
};

/// T_a_c from T_a_b and T_b_c.
[[nodiscard]] Transform operator*(const Transform& T_a_b, const Transform& T_b_c);

/// T_b_a; nothing if the 3 x 3 part is singular or a number is not finite. The last row is taken to be 0 0 0 1.
[[nodiscard]] std::optional<Transform> inverse(const Transform& T_a_b);

/// Largest deviation of R^T R from the identity, R the 3 x 3 part: 0 for a rotation, 2e-4 and less for one printed with 4
/// digits.
[[nodiscard]] double rotation_defect(const Transform& T_a_b);

/// Determinant of the 3 x 3 part: 1 for a rotation, -1 for a mirror image.
[[nodiscard]] double rotation_determinant(const Transform& T_a_b);

/// The pose of one thing relative to another, as a file specifies it.
struct PoseEdge {
  std::string a;  ///< Name of a camera or IMU of the rig, or of a further frame ("body", "vehicle").
  std::string b;
  Transform T_a_b;
  bool operator==(const PoseEdge&) const = default;
};

/// "T_cam1_cam0"
[[nodiscard]] std::string name_of(const PoseEdge& edge);

}  // namespace fca
