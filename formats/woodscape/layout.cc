// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fca::woodscape {

double centre_of(double offset, int size) { return (0.5 * size - 0.5) + offset; }

double offset_of(double centre, int size) {
  const double middle = 0.5 * size - 0.5;
  const double offset = centre - middle;
  // Of all that do, the one with the fewest digits: 0.329055 rather than 0.3290550000000394.
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    const std::optional<double> candidate = text::parse_real(text::format_short(offset, digits));
    if (candidate && middle + *candidate == centre) return *candidate;
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double candidate : {offset, std::nextafter(offset, -kInfinity), std::nextafter(offset, kInfinity)}) {
    if (middle + candidate == centre) return candidate;
  }
  return offset;
}

Transform pose_of(const Quaternion& quaternion, const std::array<double, 3>& translation) {
  double norm = 0.0;
  for (const double value : quaternion) norm += value * value;
  norm = std::sqrt(norm);
  const double x = quaternion[0] / norm;
  const double y = quaternion[1] / norm;
  const double z = quaternion[2] / norm;
  const double w = quaternion[3] / norm;
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

namespace {

/// Shepperd's method: the largest of the four components is taken from the diagonal, the others are divided by it.
Quaternion from_rotation(const Transform& R) {
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

}  // namespace

Quaternion quaternion_of(const Transform& T) { return from_rotation(T); }

std::array<double, 3> translation_of(const Transform& T) { return {T(0, 3), T(1, 3), T(2, 3)}; }

}  // namespace fca::woodscape
