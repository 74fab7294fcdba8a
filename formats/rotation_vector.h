// SPDX-License-Identifier: BSD-3-Clause
// Rotations as an axis times the angle in radians (Rodrigues' formula; cv::Rodrigues, mrcal).
#pragma once

#include <fca/rig/transform.h>

#include <array>

namespace fca {

using RotationVector = std::array<double, 3>;

/// Sets the 3 x 3 part of a pose; any angle is a rotation.
void set_rotation(const RotationVector& vector, Transform& T_a_b);

/// Of the rotation nearest to the 3 x 3 part; at most half a turn.
[[nodiscard]] RotationVector rotation_vector_of(const Transform& T_a_b);

}  // namespace fca
