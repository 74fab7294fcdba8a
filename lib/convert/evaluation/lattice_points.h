// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lattice.h"
#include "line.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace fca::internal {

/// Collects points. Evaluates them and passes them to the sink as soon as they fill a batch.
class LatticePoints {
 public:
  LatticePoints(const Scorer& scorer, const LatticeSink& sink) : scorer_(scorer), sink_(sink) {}

  /// Adds a single point, which stands only for its own error: its spread is 0.
  void add(const Pixel& pixel, double weight) {
    if (count_ == Batch::kSize) finish();
    batch_.u[count_] = pixel[0];
    batch_.v[count_] = pixel[1];
    batch_.weight[count_] = weight;
    joined_[count_++] = 0.0;
    ++added_;
  }
  /// Adds a row of at most Batch::kSize points on a line. `places`: fractions of the line's length, ascending from 0 to 1. The
  /// errors of the neighbours in the row determine the spread of each point.
  void add_row(const Line& line, std::span<const double> places, std::span<const double> weights) {
    if (count_ + places.size() > Batch::kSize) finish();
    const double right = line.to[0] - line.from[0];
    const double down = line.to[1] - line.from[1];
    double* const u = &batch_.u[count_];
    double* const v = &batch_.v[count_];
    for (std::size_t k = 0; k < places.size(); ++k) {
      u[k] = line.from[0] + places[k] * right;
      v[k] = line.from[1] + places[k] * down;
    }
    std::ranges::copy(weights, &batch_.weight[count_]);
    std::fill_n(&joined_[count_], places.size(), 1.0);
    joined_[count_] = 0.0;
    count_ += places.size();
    added_ += places.size();
  }
  /// Evaluates the points of the unfinished batch and passes them to the sink.
  void finish();
  /// The number of points added so far.
  [[nodiscard]] std::size_t added() const { return added_; }

 private:
  void split_rows_at_verdicts();
  void find_spreads();

  const Scorer& scorer_;
  const LatticeSink& sink_;
  Batch batch_;
  std::array<double, Batch::kSize + 1> joined_{};  ///< 1 if the point is in one row with the previous point, otherwise 0.
  std::size_t count_ = 0;
  std::size_t added_ = 0;
};

}  // namespace fca::internal
