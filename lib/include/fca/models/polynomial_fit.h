// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fca {

/// Coefficients c[0] .. c[count - 1] with sum c[i] x^i near y at all points (least squares), for `count` so large that the
/// powers of x are all but dependent: of the polynomials that fit equally well to rounding, the one with the smallest terms.
/// That is what a program's own rounding makes the least of. Nothing if there are fewer points than coefficients.
[[nodiscard]] std::vector<double> fit_powers(std::span<const double> x, std::span<const double> y, std::size_t count);

}  // namespace fca
