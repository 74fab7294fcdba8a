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

Transform pose_of(const Quaternion& quaternion, const std::array<double, 3>& translation) {
  const auto& [x, y, z, w] = quaternion;
  Transform T;
  T.values = {1.0 - 2.0 * (y * y + z * z),
              2.0 * (x * y - z * w),
              2.0 * (x * z + y * w),
              translation[0],
              2.0 * (x * y + z * w),
              1.0 - 2.0 * (x * x + z * z),
              2.0 * (y * z - x * w),
              translation[1],
              2.0 * (x * z - y * w),
              2.0 * (y * z + x * w),
              1.0 - 2.0 * (x * x + y * y),
              translation[2],
              0.0,
              0.0,
              0.0,
              1.0};
  return T;
}

/// Shepperd's method: the largest of the four components is taken from the diagonal, the others are divided by it.
Quaternion quaternion_of(const Transform& R) {
  const std::array<double, 4> squares = {1.0 + R(0, 0) - R(1, 1) - R(2, 2), 1.0 - R(0, 0) + R(1, 1) - R(2, 2),
                                         1.0 - R(0, 0) - R(1, 1) + R(2, 2), 1.0 + R(0, 0) + R(1, 1) + R(2, 2)};
  const std::array<std::array<double, 4>, 4> products = {
      {{squares[0], R(0, 1) + R(1, 0), R(0, 2) + R(2, 0), R(2, 1) - R(1, 2)},
       {R(0, 1) + R(1, 0), squares[1], R(1, 2) + R(2, 1), R(0, 2) - R(2, 0)},
       {R(0, 2) + R(2, 0), R(1, 2) + R(2, 1), squares[2], R(1, 0) - R(0, 1)},
       {R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1), squares[3]}}};
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
  Quaternion q = products[largest];
  double norm = 0.0;
  for (const double value : q) norm += value * value;
  // + 0.0 makes a negative zero positive.
  const double scale = (q[3] < 0.0 ? -1.0 : 1.0) / std::sqrt(norm);
  for (double& value : q) value = value * scale + 0.0;
  return q;
}

Quaternion normalised(const Quaternion& quaternion) {
  double norm = 0.0;
  for (const double value : quaternion) norm += value * value;
  norm = std::sqrt(norm);
  Quaternion result = quaternion;
  for (double& value : result) value /= norm;
  return result;
}

Quaternion signed_as(const Quaternion& q, const Quaternion& other) {
  double product = 0.0;
  for (std::size_t i = 0; i < q.size(); ++i) product += q.at(i) * other.at(i);
  return product >= 0.0 ? q : Quaternion{-q[0], -q[1], -q[2], -q[3]};
}

std::array<double, 3> translation_of(const Transform& T_a_b) { return {T_a_b(0, 3), T_a_b(1, 3), T_a_b(2, 3)}; }

double distance_of(const Transform& T_a_b) { return std::hypot(T_a_b(0, 3), T_a_b(1, 3), T_a_b(2, 3)); }

double distance_between(const Transform& a, const Transform& b) {
  return std::hypot(a(0, 3) - b(0, 3), a(1, 3) - b(1, 3), a(2, 3) - b(2, 3));
}

std::array<double, 3> rotation_vector(const Transform& T_a_b) {
  const auto [x, y, z, w] = quaternion_of(T_a_b);
  const double sine = std::hypot(x, y, z);  // of half the angle
  const double scale = sine > 0.0 ? 2.0 * std::atan2(sine, w) / sine : 2.0;
  return {scale * x, scale * y, scale * z};
}

}  // namespace fca
