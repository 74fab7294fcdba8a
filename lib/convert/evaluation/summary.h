// SPDX-License-Identifier: BSD-3-Clause
// Error statistics of many points.
#pragma once

#include "scorer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace fca::internal {

/// Error statistics of points, which are added batch by batch: shares of the image, mean, rms, percentiles, statistics of angle
/// bands, and the worst points.
class Summary {
 public:
  /// `bins_per_octave`: the number of bins between an error and its double, a power of 2. Percentiles are exact up to a factor
  /// of 2^(1 / bins_per_octave).
  explicit Summary(int bins_per_octave);

  /// Adds the first `count` points of the batch.
  void add(const Batch& batch, std::size_t count);
  /// Does the same for pixels, points with the weight 1 and the spread 0, in a third of the time.
  void add_pixels(const Batch& batch, std::size_t count);
  /// The statistics without a bound. The maximum is the error of the worst point.
  [[nodiscard]] ErrorStatistics statistics(const FieldOfView& field_of_view) const;
  /// The kWorst points with the largest errors (or all points, if there are fewer), the worst first.
  [[nodiscard]] const std::vector<Point>& worst() const { return worst_; }
  /// The number of points with this verdict.
  [[nodiscard]] long long count(Verdict verdict) const;

  static constexpr double kBandDegrees = 10.0;  ///< The width of an angle band [deg].

 private:
  static constexpr std::size_t kBands = 18;
  static constexpr std::size_t kWorst = 12;
  using BinOfPoints = std::array<std::int32_t, Batch::kSize>;
  /// The errors [px] of the lower and the upper half of the weight of each point of a batch, and their bins. They are half of
  /// the point's spread below and above its error.
  struct BinsOfPoints {
    Batch::Lane low, high;
    BinOfPoints low_bin, high_bin;
  };
  /// Finds the bin of each error.
  void find_bins(const Batch::Lane& errors, std::size_t count, BinOfPoints& found) const;
  void find_bins(const Batch& batch, std::size_t count, BinsOfPoints& found) const;
  /// Adds the consecutive scored points from number `begin` on that are in the same band, and returns the index after the last
  /// of them. `add_points(begin, end, band)` adds points to the bins and to the sums of their band.
  template <class AddPoints>
  std::size_t add_band(const Batch& batch, std::size_t begin, std::size_t count, const AddPoints& add_points);
  /// Adds all points of a batch, band by band.
  template <class AddPoints>
  void add_bands(const Batch& batch, std::size_t count, const AddPoints& add_points);
  /// The index of the band of an angle with this cosine.
  [[nodiscard]] std::size_t band_of(double cosine) const;
  /// The errors [px] below which these shares of the weight of all scored points lie. The shares must be ascending.
  template <std::size_t N>
  [[nodiscard]] std::array<double, N> percentiles(const std::array<double, N>& shares) const;
  /// A point with a larger error [px] is one of the worst. -1 while there are fewer than kWorst points.
  [[nodiscard]] double worst_threshold() const;
  /// Adds a point to the worst ones, and removes the best of them if they are too many.
  void keep_worst(const Point& point);
  /// The weight of all points with this verdict, in pixels.
  [[nodiscard]] double weight(Verdict verdict) const;

  struct Band {
    double weight = 0.0;
    double square = 0.0;  ///< The sum of weighted squared errors [px^2].
    double max = 0.0;
    long long count = 0;
  };
  struct Bin {
    double weight = 0.0;
    double sum = 0.0;  ///< The sum of weighted errors [px].
  };
  int bin_bits_;  ///< Binary logarithm of the number of bins per octave.
  std::vector<Bin> bins_;
  std::array<double, kBands> band_cosine_{};  ///< Cosine of the largest angle of each band.
  std::array<Band, kBands> bands_{};
  std::array<double, 2> weight_{};    ///< Weights of the points that are not scored, by verdict.
  std::array<long long, 2> count_{};  ///< Their numbers, by verdict.
  double sum_ = 0.0;                  ///< The sum of the weighted errors of all scored points [px].
  std::vector<Point> worst_;
};

}  // namespace fca::internal
