// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "judge_scorer.h"

#include <array>
#include <span>
#include <vector>

namespace fca::internal {

/// Sums over scored points, which may come in pieces: shares, moments, angle bands, percentiles, and the worst points.
class Summary {
 public:
  /// `bins_per_octave`: how finely errors are sorted; percentiles are exact to a factor 2^(1 / bins_per_octave), from above.
  explicit Summary(int bins_per_octave);

  void add(std::span<const Point> points);
  /// All but bound; the maximum is the worst point's. `points`, if they are all that was added, make the percentiles exact.
  [[nodiscard]] Judgement judgement(const Domain& domain, std::span<const Point> points = {}) const;
  /// Sorted, the worst first.
  [[nodiscard]] const std::vector<Point>& worst() const { return worst_; }
  [[nodiscard]] long long count(Verdict verdict) const { return count_[static_cast<std::size_t>(verdict)]; }

 private:
  static constexpr std::size_t kBands = 18;  ///< of 10 degrees
  static constexpr std::size_t kWorst = 12;
  [[nodiscard]] std::size_t bin_of(double error) const;
  [[nodiscard]] std::size_t band_of(double cosine) const;
  /// The errors below which these shares of the scored weight lie.
  [[nodiscard]] std::array<double, 3> percentiles(const std::array<double, 3>& fractions, std::span<const Point> points) const;
  void keep_if_bad(const Point& point);

  struct Band {
    double weight = 0.0;
    double square = 0.0;
    double max = 0.0;
  };
  int bins_per_octave_;
  int bin_bits_;  ///< Their binary logarithm.
  std::vector<double> bins_;
  std::array<double, kBands> band_cosine_{};  ///< of the angle at which the band ends
  std::array<Band, kBands> bands_{};
  std::array<double, 3> weight_{};  ///< by verdict
  std::array<long long, 3> count_{};
  double sum_ = 0.0;
  std::vector<Point> worst_;
};

}  // namespace fca::internal
