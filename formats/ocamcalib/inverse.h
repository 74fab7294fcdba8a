// SPDX-License-Identifier: BSD-3-Clause
// The inverse polynomial of calib_results.txt: how far one is from the exact inverse of the direct polynomial, and a new one.
#pragma once

#include <fca/rig/rig.h>

#include <span>
#include <vector>

namespace fca::ocamcalib {

/// The longest one that programs hold (MAX_POL_LENGTH of ocam_functions.h).
inline constexpr std::size_t kMostCoefficients = 64;

/// b: rho = sum b_i theta^i, theta = angle from the axis - pi / 2.
struct InversePolynomial {
  std::vector<double> coefficients;
  double error_px = 0.0;  ///< Its largest distance from the exact inverse over the lens.
};

/// The largest distance in pixels between world2cam with these coefficients and the exact inverse of the camera's direct
/// polynomial, over the lens: the image, as far as the direct polynomial has an inverse. `camera` holds the model ocamcalib and
/// a size. Infinite if a value is no number.
[[nodiscard]] double inverse_error(const Camera& camera, std::span<const double> coefficients);

/// As few coefficients as are within 1e-6 px over the lens; the best that `most` (at most kMostCoefficients) can do where none
/// is.
[[nodiscard]] InversePolynomial fit_inverse(const Camera& camera, std::size_t most = kMostCoefficients);

}  // namespace fca::ocamcalib
