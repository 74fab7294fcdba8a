// SPDX-License-Identifier: BSD-3-Clause
#include "judge_summary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace fca::internal {

namespace {

constexpr double kBandDegrees = 10.0;
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
// Errors outside 2^-60 .. 2^20 px count as these.
constexpr int kSmallestOctave = -60;
constexpr int kOctaves = 80;
constexpr int kMantissaBits = 52;
constexpr int kExponentBias = 1023;

}  // namespace

Summary::Summary(int bins_per_octave)
    : bins_per_octave_(bins_per_octave), bins_(static_cast<std::size_t>(kOctaves * bins_per_octave), 0.0) {
  for (std::size_t i = 0; i < kBands; ++i)
    band_cosine_[i] = std::cos(kBandDegrees * kRadiansPerDegree * static_cast<double>(i + 1));
  band_cosine_.back() = -2.0;
}

/// The leading bits of a double, exponent and first bits of the mantissa, count bins of equal ratio (nearly), without a
/// logarithm.
std::size_t Summary::bin_of(double error) const {
  const int bits = std::bit_width(static_cast<unsigned>(bins_per_octave_)) - 1;
  const auto leading = static_cast<long long>(std::bit_cast<std::uint64_t>(error) >> (kMantissaBits - bits));
  const long long first = static_cast<long long>(kExponentBias + kSmallestOctave) << bits;
  return static_cast<std::size_t>(std::clamp(leading - first, 0LL, static_cast<long long>(bins_.size()) - 1));
}

void Summary::keep_if_bad(const Point& point) {
  if (worst_.size() == kWorst && !(point.error > worst_.back().error)) return;
  worst_.insert(std::ranges::upper_bound(worst_, point.error, std::ranges::greater{}, &Point::error), point);
  if (worst_.size() > kWorst) worst_.pop_back();
}

void Summary::add(std::span<const Point> points) {
  for (const Point& p : points) {
    const auto verdict = static_cast<std::size_t>(p.verdict);
    weight_[verdict] += p.weight;
    ++count_[verdict];
    if (p.verdict != Verdict::kScored) continue;
    keep_if_bad(p);
    const double weighted = p.weight * p.error;
    sum_ += weighted;
    square_sum_ += weighted * p.error;
    bins_[bin_of(p.error)] += p.weight;
    std::size_t i = 0;
    while (p.cosine <= band_cosine_[i]) ++i;
    Band& band = bands_[i];
    band.weight += p.weight;
    band.square += weighted * p.error;
    band.max = std::max(band.max, p.error);
  }
}

/// The bin first, then the points in it.
double Summary::percentile(double fraction, std::span<const Point> points) const {
  const double wanted = fraction * weight_[static_cast<std::size_t>(Verdict::kScored)];
  double sum = 0.0;
  std::size_t bin = 0;
  for (; bin + 1 < bins_.size(); ++bin) {
    if (sum + bins_[bin] >= wanted) break;
    sum += bins_[bin];
  }
  if (points.empty()) {
    const double octave = std::floor(static_cast<double>(bin + 1) / bins_per_octave_);
    const double mantissa = static_cast<double>(bin + 1) / bins_per_octave_ - octave;
    const double edge = std::ldexp(1.0 + mantissa, kSmallestOctave + static_cast<int>(octave));
    return std::min(edge, worst_.front().error);
  }
  std::vector<std::pair<double, double>> in_bin;
  for (const Point& p : points) {
    if (p.verdict == Verdict::kScored && bin_of(p.error) == bin) in_bin.emplace_back(p.error, p.weight);
  }
  std::ranges::sort(in_bin);
  for (const auto& [error, weight] : in_bin) {
    sum += weight;
    if (sum >= wanted) return error;
  }
  return in_bin.empty() ? 0.0 : in_bin.back().first;
}

Judgement Summary::judgement(const Domain& domain, std::span<const Point> points) const {
  Judgement result;
  result.coverage.max_angle_deg = domain.max_angle_rad / kRadiansPerDegree;
  result.coverage.why = domain.why;
  // From pixels to shares of the image, which sum to 1.
  const double total = weight_[0] + weight_[1] + weight_[2];
  const double scored = weight_[static_cast<std::size_t>(Verdict::kScored)];
  result.coverage.scored = scored / total;
  result.coverage.outside_lens = weight_[static_cast<std::size_t>(Verdict::kOutsideLens)] / total;
  result.coverage.unrepresentable = weight_[static_cast<std::size_t>(Verdict::kUnrepresentable)] / total;
  if (!(scored > 0.0)) return result;
  ErrorSummary& error = result.error;
  error.rms = std::sqrt(square_sum_ / scored);
  error.mean = sum_ / scored;
  error.p50 = percentile(0.50, points);
  error.p95 = percentile(0.95, points);
  error.p99 = percentile(0.99, points);
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
