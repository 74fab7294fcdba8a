// SPDX-License-Identifier: BSD-3-Clause
#include "lattice_points.h"

#include <algorithm>
#include <cmath>

namespace fca::internal {

void LatticePoints::finish() {
  joined_[0] = 0.0;
  joined_[count_] = 0.0;
  if (!scorer_.score(batch_, count_)) split_rows_at_verdicts();
  find_spreads();
  sink_(batch_, count_);
  count_ = 0;
}

/// Cuts rows between neighbours with different verdicts, since the error jumps there. Sets the error of points that are not
/// scored to 0.
void LatticePoints::split_rows_at_verdicts() {
  for (std::size_t i = 0; i < count_; ++i) {
    if (i > 0 && batch_.verdict[i] != batch_.verdict[i - 1]) joined_[i] = 0.0;
    if (batch_.verdict[i] != Verdict::kScored) batch_.error[i] = 0.0;
  }
}

/// Sets the spread of each point: half of the range of errors for which it stands. The range reaches half way to each neighbour
/// in the row; at an end of the row, it reaches as far beyond the point as towards the only neighbour. So the mean errors of
/// the lower and the upper half of the point's weight differ by its spread.
void LatticePoints::find_spreads() {
  const Batch::Lane& error = batch_.error;
  std::array<double, Batch::kSize + 1>
      rise;  // the error minus the error of the previous point in the row; 0 for the first point
  rise[0] = 0.0;
  rise[count_] = 0.0;
  for (std::size_t i = 1; i < count_; ++i) rise[i] = joined_[i] * (error[i] - error[i - 1]);
  for (std::size_t i = 0; i < count_; ++i)
    batch_.spread[i] = (0.5 - 0.25 * joined_[i] * joined_[i + 1]) * std::abs(rise[i] + rise[i + 1]);
}

}  // namespace fca::internal
