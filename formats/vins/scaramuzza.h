// SPDX-License-Identifier: BSD-3-Clause
// camodocal's scaramuzza is OCamCalib's model in other numbers. It counts x along the columns, and the affine part's fixed 1
// stands for the rows:
//
//   u = ac x + ad y + cx,  v = ae x + y + cy,  (x, y) = rho (X, Y) / |(X, Y)| of the ray (X, Y, Z)
//
// OCamCalib's is v = c X' + d Y' + row, u = e X' + Y' + column. With radii c times as long both are one: ac = 1 / c, ad = e /
// c, ae = d / c, p_i = c^(1 - i) a_i, inverse p_i = c b_i.
#pragma once

#include "layout.h"

#include <array>

namespace fca::vins {

/// How many coefficients camodocal holds (SCARAMUZZA_POLY_SIZE, SCARAMUZZA_INV_POLY_SIZE).
inline constexpr std::size_t kDirectCount = 5;
inline constexpr std::size_t kInverseCount = 20;

inline constexpr std::string_view kDirect = "poly_parameters";
inline constexpr std::string_view kInverse = "inv_poly_parameters";
inline constexpr std::string_view kAffine = "affine_parameters";

/// camodocal's numbers.
struct Scaramuzza {
  std::array<double, kDirectCount> direct{};
  std::array<double, kInverseCount> inverse{};
  double ac = 1.0;
  double ad = 0.0;
  double ae = 0.0;
  double cx = 0.0;
  double cy = 0.0;
};

/// Our model (ocamcalib) of them. Precondition: ac > 0.
[[nodiscard]] CameraModel ocamcalib_of(const Scaramuzza& numbers);
/// OCamCalib's inverse polynomial.
[[nodiscard]] std::vector<double> inverse_of(const Scaramuzza& numbers);

[[nodiscard]] std::vector<Section> scaramuzza_sections(const CameraModel& model, std::span<const double> inverse);

}  // namespace fca::vins
