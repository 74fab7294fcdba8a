// SPDX-License-Identifier: BSD-3-Clause
#include "rectification.h"

#include "layout.h"
#include "numbers.h"

#include <fca/rig/limits.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>

namespace fca::opencv {

namespace {

std::optional<std::vector<double>> matrix_at(std::string_view key, int rows, int cols, fields::Reader& reader) {
  const text::Node* node = text::find(reader.document().root(), key, kDialect);
  if (node == nullptr) return std::nullopt;
  const std::optional<Numbers> numbers = read_numbers(*node, std::string(key), reader);
  if (!numbers || numbers->rows != rows || numbers->cols != cols) return std::nullopt;
  return numbers->values;
}

/// The same in the file's digits.
bool are_equal(double a, double b) {
  constexpr double kPrinted = 1e-6;
  return std::abs(a - b) <= kPrinted * std::abs(a);
}

/// Far beyond any image's.
bool has_limits(double value) {
  constexpr double kLargest = 1e9;
  return std::abs(value) <= kLargest;
}

bool is_rotation(const Transform& R) {
  constexpr double kPrintedWithThreeDigits = 2e-3;
  return rotation_determinant(R) > 0.0 && rotation_defect(R) <= kPrintedWithThreeDigits;
}

Transform rotation_of(const std::vector<double>& R) {
  Transform T;
  for (int i = 0; i < 9; ++i) T(i / 3, i % 3) = R[static_cast<std::size_t>(i)];
  return T;
}

}  // namespace

std::optional<RectifiedPair> read_rectification(const text::Document& document) {
  Diagnostics discarded;  // who has no use for them is not to be told of them
  fields::Reader reader(document, kDialect, discarded);
  const auto R1 = matrix_at("R1", 3, 3, reader);
  const auto R2 = matrix_at("R2", 3, 3, reader);
  const auto P1 = matrix_at("P1", 3, 4, reader);
  const auto P2 = matrix_at("P2", 3, 4, reader);
  if (!R1 || !R2 || !P1 || !P2) return std::nullopt;
  const std::vector<double>& a = *P1;
  const std::vector<double>& b = *P2;
  const bool is_vertical = b[7] != 0.0;
  const bool is_pair = a[0] > 0.0 && a[5] > 0.0 && are_equal(a[0], b[0]) && are_equal(a[5], b[5]) && a[3] == 0.0 &&
                       a[7] == 0.0 && (b[3] != 0.0) != is_vertical;
  RectifiedPair pair;
  pair.views = {RectifiedPair::View{"cam0", rotation_of(*R1), {a[2], a[6]}},
                RectifiedPair::View{"cam1", rotation_of(*R2), {b[2], b[6]}}};
  if (!is_pair || !is_rotation(pair.views[0].T_rectified_camera) || !is_rotation(pair.views[1].T_rectified_camera))
    return std::nullopt;
  pair.focal_lengths = {a[0], a[5]};
  pair.is_vertical = is_vertical;
  pair.offset_m = is_vertical ? -b[7] / b[5] : -b[3] / b[0];
  const bool is_in_limits = !problem_with_baseline(std::abs(pair.offset_m)).is_said() && std::ranges::all_of(a, has_limits) &&
                            std::ranges::all_of(b, has_limits);
  return is_in_limits ? std::optional(pair) : std::nullopt;
}

std::vector<fields::Field> rectification_fields(const RectifiedPair& pair) {
  std::vector<fields::Field> fields;
  for (std::size_t i = 0; i < 2; ++i) {
    const Transform& T = pair.views.at(i).T_rectified_camera;
    const std::array R = {T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2)};
    fields.push_back(fields::matrix(std::string(kRectificationKeys.at(i)), R, 3, "d"));
  }
  const auto& [fx, fy] = pair.focal_lengths;
  const double offset = pair.offset_m;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [cx, cy] = pair.views.at(i).centre;
    std::array P = {fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0};
    if (i == 1) P.at(pair.is_vertical ? 7 : 3) = -(pair.is_vertical ? fy : fx) * offset;
    fields.push_back(fields::matrix(std::string(kRectificationKeys.at(2 + i)), P, 4, "d"));
  }
  const Pixel& centre = pair.views[0].centre;
  const std::size_t axis = pair.is_vertical ? 1 : 0;
  const double shift = (centre.at(axis) - pair.views[1].centre.at(axis));
  const std::array Q = {1.0, 0.0, 0.0, -centre[0], 0.0, 1.0, 0.0,          -centre[1],
                        0.0, 0.0, 0.0, fx,         0.0, 0.0, 1.0 / offset, 0.0 - shift / offset};
  fields.push_back(fields::matrix(std::string(kRectificationKeys[4]), Q, 4, "d"));
  return fields;
}

}  // namespace fca::opencv
