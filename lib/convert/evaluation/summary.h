// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scorer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace fca::internal {

/// Sums over scored points, which may come in pieces: shares, moments, angle bands, percentiles, and the worst points.
class Summary {
 public:
  /// `bins_per_octave`: how finely errors are sorted; percentiles are exact to a factor 2^(1 / bins_per_octave).
  explicit Summary(int bins_per_octave);

  void add(const Batch& batch, std::size_t count);
  /// The same of points that weigh 1 each and have no spread, as pixels do, in a third of the time.
  void add_pixels(const Batch& batch, std::size_t count);
  /// All but bound; the maximum is the worst point's.
  [[nodiscard]] Judgement judgement(const Domain& domain) const;
  /// Sorted, the worst first.
  [[nodiscard]] const std::vector<Point>& worst() const { return worst_; }
  [[nodiscard]] long long count(Verdict verdict) const;

  static constexpr double kBandDegrees = 10.0;

 private:
  static constexpr std::size_t kBands = 18;
  static constexpr std::size_t kWorst = 12;
  /// The two errors for which each point of a batch stands, and their bins.
  using BinOfPoints = std::array<std::int32_t, Batch::kSize>;
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
  /// The errors below which these shares of the scored weight lie; the shares rise.
  template <std::size_t N>
  [[nodiscard]] std::array<double, N> percentiles(const std::array<double, N>& shares) const;
  /// What a point's error must exceed to be one of the worst.
  [[nodiscard]] double smallest_bad() const;
  void keep_bad(const Point& point);
  [[nodiscard]] double weight(Verdict verdict) const;

  struct Band {
    double weight = 0.0;
    double square = 0.0;
    double max = 0.0;
    long long count = 0;
  };
  struct Bin {
    double weight = 0.0;
    double sum = 0.0;  ///< of weighted errors
  };
  int bin_bits_;  ///< Binary logarithm of the number of bins per octave.
  std::vector<Bin> bins_;
  std::array<double, kBands> band_cosine_{};  ///< of the angle at which the band ends
  std::array<Band, kBands> bands_{};
  std::array<double, 2> weight_{};  ///< By verdict of what is not scored.
  std::array<long long, 2> count_{};
  double sum_ = 0.0;
  std::vector<Point> worst_;
};

}  // namespace fca::internal
