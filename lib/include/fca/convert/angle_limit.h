// SPDX-License-Identifier: BSD-3-Clause
// "Not further from the axis than", fast for many rays.
#pragma once

#include <fca/models/camera_model.h>

#include <cmath>
#include <numbers>

namespace fca {

/// Decided by the cosine of a unit ray, and by the angle itself where that is close.
struct AngleLimit {
  double angle;   ///< From the axis [rad].
  double cosine;  ///< Below any where nothing limits the angle.

  static constexpr double kClose = 1e-9;

  explicit AngleLimit(double angle_rad) : angle(angle_rad), cosine(angle_rad < std::numbers::pi ? std::cos(angle_rad) : -2.0) {}

  [[nodiscard]] bool admits(const Ray& unit_ray) const {
    const double difference = unit_ray[2] - cosine;
    return std::abs(difference) > kClose ? difference > 0.0 : angle_from_axis(unit_ray) <= angle;
  }
  /// By the cosine alone: true only where that is not close.
  [[nodiscard]] bool surely_admits(double ray_cosine) const { return ray_cosine - cosine > kClose; }
};

}  // namespace fca
