// SPDX-License-Identifier: BSD-3-Clause
// The limits of the verdict on pixels. examples/openvins_simulation shows what errors of this size do to a trajectory.
#pragma once

namespace fca {

/// A value up to `ready` is ready to use, one up to `care` is to be used with care, and a larger one is not to be used.
struct VerdictLimits {
  double ready = 0.0;
  double care = 0.0;
};

/// The rms of the distances between the camera's pixels and those that the program sees [px].
inline constexpr VerdictLimits kVerdictRmsPx = {0.25, 2.0};
/// The 99th percentile of these distances [px].
inline constexpr VerdictLimits kVerdictP99Px = {1.0, 5.0};
/// The share of the pixels for which the program has no right ray.
inline constexpr VerdictLimits kVerdictNoRays = {0.01, 0.5};

}  // namespace fca
