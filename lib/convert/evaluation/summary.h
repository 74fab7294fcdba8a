// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scorer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace fca::internal {

/// Sums over scored points, added batch by batch: shares of the image, moments, angle bands, percentiles and the worst points.
class Summary {
 public:
  /// `bins_per_octave`: the number of bins between an error and its double, a power of 2. Percentiles are exact to a factor of
  /// 2^(1 / bins_per_octave).
  explicit Summary(int bins_per_octave);

  void add(const Batch& batch, std::size_t count);
  /// The same for points that weigh 1 each and have no spread, as pixels do. It takes a third of the time.
  void add_pixels(const Batch& batch, std::size_t count);
  /// The evaluation result without a bound. Its maximum is the error of the worst point.
  [[nodiscard]] ErrorStatistics statistics(const FieldOfView& field_of_view) const;
  /// The worst points, at most kWorst, the worst first.
  [[nodiscard]] const std::vector<Point>& worst() const { return worst_; }
  [[nodiscard]] long long count(Verdict verdict) const;

  static constexpr double kBandDegrees = 10.0;

 private:
  static constexpr std::size_t kBands = 18;
  static constexpr std::size_t kWorst = 12;
  using BinOfPoints = std::array<std::int32_t, Batch::kSize>;
  /// The two ends of the range of errors for which each point of a batch stands [px], and the bins of these errors.
  struct BinsOfPoints {
    Batch::Lane low, high;
    BinOfPoints low_bin, high_bin;
  };
  void find_bins(const Batch::Lane& errors, std::size_t count, BinOfPoints& found) const;
  void find_bins(const Batch& batch, std::size_t count, BinsOfPoints& found) const;
  /// Adds points from `begin` on, and returns the end of these; `add_points` those of one band.
  template <class AddPoints>
  std::size_t add_band(const Batch& batch, std::size_t begin, std::size_t count, const AddPoints& add_points);
  template <class AddPoints>
  void add_bands(const Batch& batch, std::size_t count, const AddPoints& add_points);
  [[nodiscard]] std::size_t band_of(double cosine) const;
  /// The errors [px] below which these fractions of the scored weight lie. The fractions must be ascending.
  template <std::size_t N>
  [[nodiscard]] std::array<double, N> percentiles(const std::array<double, N>& shares) const;
  /// The error [px] above which a point is among the worst; -1 while there is room for more points.
  [[nodiscard]] double worst_threshold() const;
  void keep_worst(const Point& point);
  [[nodiscard]] double weight(Verdict verdict) const;

  struct Band {
    double weight = 0.0;
    double square = 0.0;
    double max = 0.0;
    long long count = 0;
  };
  struct Bin {
    double weight = 0.0;
    double sum = 0.0;  ///< weighted errors [px]
  };
  int bin_bits_;  ///< Binary logarithm of the number of bins per octave.
  std::vector<Bin> bins_;
  std::array<double, kBands> band_cosine_{};  ///< Cosine of the largest angle of each band.
  std::array<Band, kBands> bands_{};
  std::array<double, 2> weight_{};  ///< Weights of the points that are not scored, by verdict.
  std::array<long long, 2> count_{};
  double sum_ = 0.0;
  std::vector<Point> worst_;
};

}  // namespace fca::internal
