// SPDX-License-Identifier: BSD-3-Clause
// What the facts of a rig may be, as problem_with() of camera_model.h says it of parameters. Beyond these limits a number is a
// common mistake or has another unit, and what follows from it (an inverse pose, baseline times focal length) overflows.
// Readers ask at the number's place, the command of its options, writers of the whole rig.
#pragma once

#include <fca/message.h>
#include <fca/rig/rig.h>

#include <cstddef>
#include <vector>

namespace fca {

inline constexpr double kLongestDistance = 1e6;    ///< m: no two parts of a rig are farther apart.
inline constexpr double kLongestTimeOffset = 1e6;  ///< s: eleven days.
/// s: time offsets of two cameras that differ less move no image by a pixel (at 10 px per ms).
inline constexpr double kSameClock = 1e-4;
/// px: larger than any sensor and than JPEG can hold; keeps what is computed from it far from overflow.
inline constexpr int kLargestImageSide = 100'000;
/// Of one rig. The largest light stages have some hundred; poses are compared each with each.
inline constexpr std::size_t kMostCameras = 100;

/// What rotation_defect() may be of a rotation and of its inverse. A rotation printed with a single digit is off by 0.05 in an
/// element, thus by up to 2 sqrt(3) 0.05 = 0.17 in R^T R, and its inverse by 0.21.
inline constexpr double kCoarsestRotation = 0.25;
/// What an element of such a rotation may be at most: sqrt(1 + 0.25), rounded up.
inline constexpr double kLargestRotationElement = 1.12;

/// What is wrong with an image's size; says nothing if it may be.
[[nodiscard]] Message problem_with_image_size(const ImageSize& size);
/// What is wrong with an element of a translation [m]; says nothing if it may be.
[[nodiscard]] Message problem_with_translation(double metres);
/// The same of a baseline, which is positive besides.
[[nodiscard]] Message problem_with_baseline(double metres);
[[nodiscard]] Message problem_with_time_offset(double seconds);
/// The same of the 3 x 3 part of a pose.
[[nodiscard]] Message problem_with_rotation(const Transform& T_a_b);

/// Everything that must not be written, "out-of-range": facts beyond these limits and numbers that are not finite. {0} is what
/// they belong to: "cam0", "T_cam0_imu0", "rig".
[[nodiscard]] std::vector<Message> validate(const Rig& rig);

}  // namespace fca
