// SPDX-License-Identifier: BSD-3-Clause
// How far apart two poses are, the rotation nearest to what a file calls one, and rotations as quaternions.
#pragma once

#include <fca/rig/transform.h>

#include <array>
#include <optional>

namespace fca {

/// The pose with the rotation nearest to its 3 x 3 part (polar decomposition; Higham 1986); nothing if that is singular. Of a
/// mirror image it is the nearest mirror image.
[[nodiscard]] std::optional<Transform> nearest_rotation(const Transform& T_a_b);

/// R p of a direction p.
[[nodiscard]] std::array<double, 3> rotated(const Transform& T_a_b, const std::array<double, 3>& p);

/// An element of the 3 x 3 part and by how much it differs from another's.
struct ElementDifference {
  int row = 0;
  int column = 0;
  double distance = 0.0;
};
/// The largest difference of two elements of the 3 x 3 parts.
[[nodiscard]] ElementDifference largest_difference(const Transform& a, const Transform& b);

/// Angle between two rotations, in radians, [0, pi].
[[nodiscard]] double angle_between(const Transform& a, const Transform& b);

/// Along the axis of a rotation, as long as its angle [rad].
[[nodiscard]] std::array<double, 3> rotation_vector(const Transform& T_a_b);

/// Length of the translation [m].
[[nodiscard]] double distance_of(const Transform& T_a_b);

/// x y z w, as scipy's Rotation, Eigen's coeffs() and Basalt's files have it.
using Quaternion = std::array<double, 4>;

/// The pose with the rotation of a unit quaternion. Of one that is not of unit length its 3 x 3 part is no rotation, as in
/// programs that do not normalise.
[[nodiscard]] Transform pose_of(const Quaternion& quaternion, const std::array<double, 3>& translation);
/// The unit quaternion with w >= 0 of the rotation nearest to the pose's.
[[nodiscard]] Quaternion quaternion_of(const Transform& T_a_b);
/// Of length 1; the quaternion must not be 0.
[[nodiscard]] Quaternion normalised(const Quaternion& quaternion);
/// Of q and -q, which are one rotation, the one that is nearer to `other`.
[[nodiscard]] Quaternion signed_as(const Quaternion& q, const Quaternion& other);
[[nodiscard]] std::array<double, 3> translation_of(const Transform& T_a_b);

/// Distance of two translations [m].
[[nodiscard]] double distance_between(const Transform& a, const Transform& b);

}  // namespace fca
