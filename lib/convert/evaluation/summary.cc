// SPDX-License-Identifier: BSD-3-Clause
#include "summary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace fca::internal {

namespace {

/// A number above every cosine. Its negative is below every cosine.
constexpr double kAnyCosine = 2.0;
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
// The bins hold errors from 2^-60 to 2^20 px. The first and the last bin also hold smaller and larger errors.
constexpr int kSmallestOctave = -60;
constexpr int kOctaves = 80;
// The layout of a double.
constexpr int kMantissaBits = 52;
constexpr int kExponentBias = 1023;

}  // namespace

Summary::Summary(int bins_per_octave)
    : bin_bits_(static_cast<int>(std::bit_width(static_cast<unsigned>(bins_per_octave))) - 1),
      bins_(static_cast<std::size_t>(kOctaves * bins_per_octave)) {
  for (std::size_t i = 0; i < kBands; ++i)
    band_cosine_[i] = std::cos(kBandDegrees * kRadiansPerDegree * static_cast<double>(i + 1));
  band_cosine_.back() = -kAnyCosine;
}

/// The number of a bin consists of the leading bits of the error: its exponent and the first bits of its mantissa. So the ratio
/// of the largest to the smallest error is nearly the same in all bins, and no logarithm is needed.
void Summary::find_bins(const Batch::Lane& errors, std::size_t count, BinOfPoints& found) const {
  const int shift = kMantissaBits - bin_bits_;
  const auto first = static_cast<std::int32_t>((kExponentBias + kSmallestOctave) << bin_bits_);
  const auto last = static_cast<std::int32_t>(bins_.size()) - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const auto leading = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(errors[i]) >> shift);
    found[i] = std::clamp(leading - first, 0, last);
  }
}

void Summary::find_bins(const Batch& batch, std::size_t count, BinsOfPoints& found) const {
  for (std::size_t i = 0; i < count; ++i) {
    found.low[i] = std::abs(batch.error[i] - 0.5 * batch.spread[i]);
    found.high[i] = batch.error[i] + 0.5 * batch.spread[i];
  }
  find_bins(found.low, count, found.low_bin);
  find_bins(found.high, count, found.high_bin);
}

double Summary::worst_threshold() const { return worst_.size() == kWorst ? worst_.back().error : -1.0; }

void Summary::keep_worst(const Point& point) {
  worst_.insert(std::ranges::upper_bound(worst_, point.error, std::ranges::greater{}, &Point::error), point);
  if (worst_.size() > kWorst) worst_.pop_back();
}

std::size_t Summary::band_of(double cosine) const {
  std::size_t i = 0;
  while (cosine <= band_cosine_[i]) ++i;
  return i;
}

void Summary::add(const Batch& batch, std::size_t count) {
  BinsOfPoints in;
  find_bins(batch, count, in);
  Bin* const bins = bins_.data();
  add_bands(batch, count, [&](std::size_t begin, std::size_t end, Band& sums) {
    for (std::size_t i = begin; i < end; ++i) {
      const double half = 0.5 * batch.weight[i];
      Bin& low = bins[in.low_bin[i]];
      low.weight += half;
      low.sum += half * in.low[i];
      Bin& high = bins[in.high_bin[i]];
      high.weight += half;
      high.sum += half * in.high[i];
    }
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const double weighted = batch.weight[i] * batch.error[i];
      sums.weight += batch.weight[i];
      sum += weighted;
      sums.square += weighted * batch.error[i];
      sums.max = std::max(sums.max, batch.error[i]);
    }
    sum_ += sum;
  });
}

void Summary::add_pixels(const Batch& batch, std::size_t count) {
  BinOfPoints bin;
  find_bins(batch.error, count, bin);
  Bin* const bins = bins_.data();
  add_bands(batch, count, [&](std::size_t begin, std::size_t end, Band& sums) {
    // Adds twice half of the error, because add() does, so that both round in the same way.
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const double error = batch.error[i];
      const double half = 0.5 * error;
      Bin& both = bins[bin[i]];
      both.weight += 1.0;
      both.sum = (both.sum + half) + half;
      sum += error;
      sums.square += error * error;
      sums.max = std::max(sums.max, error);
    }
    sums.weight = static_cast<double>(end - begin);
    sum_ += sum;
  });
}

template <class AddPoints>
void Summary::add_bands(const Batch& batch, std::size_t count, const AddPoints& add_points) {
  for (std::size_t i = 0; i < count;) {
    if (batch.verdict[i] == Verdict::kScored) {
      i = add_band(batch, i, count, add_points);
      continue;
    }
    const auto verdict = static_cast<std::size_t>(batch.verdict[i]);
    weight_[verdict] += batch.weight[i];
    ++count_[verdict];
    ++i;
  }
}

/// Neighbours are mostly in the same band, so that the loops over points are long.
template <class AddPoints>
std::size_t Summary::add_band(const Batch& batch, std::size_t begin, std::size_t count, const AddPoints& add_points) {
  const std::size_t at = band_of(batch.z[begin]);
  const double from = at > 0 ? band_cosine_[at - 1] : kAnyCosine;
  const double to = band_cosine_[at];
  std::size_t end = begin + 1;
  while (end < count && batch.z[end] <= from && batch.z[end] > to && batch.verdict[end] == Verdict::kScored) ++end;
  Band sums;
  add_points(begin, end, sums);
  Band& band = bands_[at];
  band.weight += sums.weight;
  band.square += sums.square;
  band.max = std::max(band.max, sums.max);
  band.count += static_cast<long long>(end - begin);
  if (sums.max > worst_threshold()) {
    for (std::size_t i = begin; i < end; ++i) {
      if (batch.error[i] > worst_threshold()) keep_worst(batch.point(i));
    }
  }
  return end;
}

double Summary::weight(Verdict verdict) const {
  if (verdict != Verdict::kScored) return weight_[static_cast<std::size_t>(verdict)];
  return std::transform_reduce(bands_.begin(), bands_.end(), 0.0, std::plus{}, [](const Band& band) { return band.weight; });
}

long long Summary::count(Verdict verdict) const {
  if (verdict != Verdict::kScored) return count_[static_cast<std::size_t>(verdict)];
  return std::transform_reduce(bands_.begin(), bands_.end(), 0LL, std::plus{}, [](const Band& band) { return band.count; });
}

template <std::size_t N>
std::array<double, N> Summary::percentiles(const std::array<double, N>& shares) const {
  const double worst = worst_.front().error;
  const double scored = weight(Verdict::kScored);
  std::array<double, N> result{};
  result.fill(worst);
  std::size_t next = 0;
  double below = 0.0;
  for (const Bin& bin : bins_) {
    if (!(bin.weight > 0.0)) continue;
    below += bin.weight;
    for (; next < N && below >= shares[next] * scored; ++next) result[next] = std::min(bin.sum / bin.weight, worst);
    if (next == N) break;
  }
  return result;
}

ErrorStatistics Summary::statistics(const FieldOfView& field_of_view) const {
  ErrorStatistics result;
  result.coverage.max_angle_deg = field_of_view.max_angle_rad / kRadiansPerDegree;
  result.coverage.why = field_of_view.why;
  result.coverage.circle = field_of_view.circle;
  // Divides weights, in pixels, by their sum: the results are shares of the image.
  const double scored = weight(Verdict::kScored);
  const double outside = weight(Verdict::kOutsideLens);
  const double unrepresentable = weight(Verdict::kUnrepresentable);
  const double total = scored + outside + unrepresentable;
  result.coverage.scored = scored / total;
  result.coverage.outside_lens = outside / total;
  result.coverage.unrepresentable = unrepresentable / total;
  if (!(scored > 0.0)) return result;
  ErrorSummary& error = result.error;
  double square_sum = 0.0;
  for (const Band& band : bands_) square_sum += band.square;
  error.rms = std::sqrt(square_sum / scored);
  error.mean = sum_ / scored;
  const auto [p50, p95, p99] = percentiles(std::array{0.50, 0.95, 0.99});
  error.p50 = p50;
  error.p95 = p95;
  error.p99 = p99;
  error.max = worst_.front().error;
  error.max_at = worst_.front().pixel;
  for (std::size_t i = 0; i < kBands; ++i) {
    const Band& band = bands_[i];
    const double from = kBandDegrees * static_cast<double>(i);
    result.bands.push_back({from, from + kBandDegrees, band.weight / total,
                            band.weight > 0.0 ? std::sqrt(band.square / band.weight) : 0.0, band.max});
  }
  while (!result.bands.empty() && result.bands.back().share == 0.0) result.bands.pop_back();
  return result;
}

}  // namespace fca::internal
