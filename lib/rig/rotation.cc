// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>

namespace fca {

std::optional<Transform> nearest_rotation(const Transform& T_a_b) {
  // Newton's iteration X <- (X + X^-T) / 2 converges quadratically from a matrix that is nearly a rotation.
  Transform X = T_a_b;
  constexpr int kSteps = 20;
  for (int step = 0; step < kSteps; ++step) {
    Transform rotation = X;
    for (int row = 0; row < 3; ++row) rotation(row, 3) = 0.0;
    const std::optional<Transform> inverted = inverse(rotation);
    if (!inverted) return std::nullopt;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) X(row, column) = 0.5 * (rotation(row, column) + (*inverted)(column, row));
    }
  }
  return X;
}

std::array<double, 3> rotated(const Transform& T_a_b, const std::array<double, 3>& p) {
  std::array<double, 3> result{};
  for (int row = 0; row < 3; ++row)
    result[static_cast<std::size_t>(row)] = T_a_b(row, 0) * p[0] + T_a_b(row, 1) * p[1] + T_a_b(row, 2) * p[2];
  return result;
}

ElementDifference largest_difference(const Transform& a, const Transform& b) {
  ElementDifference largest;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double distance = std::abs(a(row, column) - b(row, column));
      if (distance > largest.distance) largest = {row, column, distance};
    }
  }
  return largest;
}

double angle_between(const Transform& a, const Transform& b) {
  double trace = 0.0;
  double squared = 0.0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      trace += a(row, column) * b(row, column);
      squared += (a(row, column) - b(row, column)) * (a(row, column) - b(row, column));
    }
  }
  // |a - b|_F = 2 sqrt(2) sin(angle / 2) is exact for small angles, the trace for large ones.
  const double sine = std::sqrt(squared / 8.0);
  return sine < 0.5 ? 2.0 * std::asin(sine) : std::acos(std::clamp((trace - 1.0) / 2.0, -1.0, 1.0));
}

double distance_of(const Transform& T_a_b) { return std::hypot(T_a_b(0, 3), T_a_b(1, 3), T_a_b(2, 3)); }

double distance_between(const Transform& a, const Transform& b) {
  return std::hypot(a(0, 3) - b(0, 3), a(1, 3) - b(1, 3), a(2, 3) - b(2, 3));
}

}  // namespace fca
