// SPDX-License-Identifier: BSD-3-Clause
// Lines of equal value on a grid: marching squares.
#pragma once

#include <fca/toolkit/image_field.h>

#include <array>
#include <vector>

namespace fca::cli {

/// A line through points in cells (column, row; the middle of the first cell is 0, 0). Closed where its ends are the same.
using ContourLine = std::vector<std::array<double, 2>>;

/// The lines on which the field has that value, the longest first. They end where cells were not scored.
[[nodiscard]] std::vector<ContourLine> contours(const ImageField& field, double level);

}  // namespace fca::cli
