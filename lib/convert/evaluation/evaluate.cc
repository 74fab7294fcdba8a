// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/evaluate.h>

#include "lattice.h"
#include "maximum.h"
#include "stages.h"
#include "summary.h"

#include <algorithm>
#include <functional>

namespace fca {

namespace internal {

namespace {

void add_pixels(const Scorer& scorer, Summary& summary) {
  const ImageSize& size = scorer.field_of_view().size;
  Batch batch;
  batch.weight.fill(1.0);
  batch.spread.fill(0.0);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width;) {
      std::size_t count = 0;
      for (; count < Batch::kSize && x < size.width; ++count, ++x) {
        batch.u[count] = static_cast<double>(x);
        batch.v[count] = static_cast<double>(y);
      }
      scorer.score(batch, count);
      summary.add_pixels(batch, count);
    }
  }
}

/// True if the error is near 0 except in a few places, where a lattice has too few points for its sums to be right. Scoring
/// every pixel of a large image takes long, so that the maximum must then exceed the rms by more.
bool is_steep(const ErrorSummary& error, const ImageSize& size) {
  constexpr long long kSmall = 500'000;
  constexpr long long kLarge = 2'000'000;
  constexpr double kSteep = 15.0;
  constexpr double kVerySteep = 100.0;
  constexpr double kNobodySees = 1e-6;  // px
  const long long pixels = 1LL * size.width * size.height;
  return pixels <= kLarge && error.max > kNobodySees && error.max > (pixels <= kSmall ? kSteep : kVerySteep) * error.rms;
}

/// Replaces the error sums of the lattice by sums over all pixels. The coverage, which gives shares of the image, stays the
/// lattice's.
void sum_over_pixels(const Scorer& scorer, ErrorStatistics& statistics) {
  constexpr int kBinsPerOctave = 64;
  Summary summary(kBinsPerOctave);
  add_pixels(scorer, summary);
  const ErrorStatistics pixels = summary.statistics(scorer.field_of_view());
  if (pixels.coverage.scored == 0.0) return;
  const ErrorSummary polished = statistics.error;
  statistics.error = pixels.error;
  statistics.error.bound = polished.bound;
  if (polished.max >= pixels.error.max) {
    statistics.error.max = polished.max;
    statistics.error.max_at = polished.max_at;
  }
  for (std::size_t i = 0; i < std::min(statistics.bands.size(), pixels.bands.size()); ++i) {
    statistics.bands[i].rms_px = pixels.bands[i].rms_px;
    statistics.bands[i].max_px = std::max(statistics.bands[i].max_px, pixels.bands[i].max_px);
  }
}

}  // namespace

Score score_on_lattice(const Scorer& scorer) {
  constexpr int kBinsPerOctave = 64;
  Summary summary(kBinsPerOctave);
  score_lattice(scorer, [&](const Batch& batch, std::size_t count) { summary.add(batch, count); });
  return {summary.statistics(scorer.field_of_view()), summary.worst()};
}

Score score_every_pixel(const Scorer& scorer) {
  constexpr int kBinsPerOctave = 1024;  // percentiles to 0.1 %
  Summary summary(kBinsPerOctave);
  add_pixels(scorer, summary);
  Score score{summary.statistics(scorer.field_of_view()), summary.worst()};
  Coverage& coverage = score.statistics.coverage;
  coverage.scored_pixels = summary.count(Verdict::kScored);
  coverage.outside_lens_pixels = summary.count(Verdict::kOutsideLens);
  coverage.unrepresentable_pixels = summary.count(Verdict::kUnrepresentable);
  // The largest error may lie between pixels, on the edge of a round field of view. The lattice has points on that edge.
  const std::vector<Point> beside = score_on_lattice(scorer).worst;
  score.worst.insert(score.worst.end(), beside.begin(), beside.end());
  std::ranges::sort(score.worst, std::ranges::greater{}, &Point::error);
  return score;
}

ErrorStatistics evaluate_all(const Scorer& scorer, Score lattice, const EvaluateOptions& options) {
  Score score = options.every_pixel ? score_every_pixel(scorer) : std::move(lattice);
  ErrorStatistics& statistics = score.statistics;
  find_maximum(scorer, score.worst, options.bound, statistics);
  if (!options.every_pixel && is_steep(statistics.error, scorer.field_of_view().size)) sum_over_pixels(scorer, statistics);
  return std::move(score.statistics);
}

}  // namespace internal

namespace {

ErrorStatistics evaluate_all(const internal::Scorer& scorer, const EvaluateOptions& options) {
  return internal::evaluate_all(scorer, options.every_pixel ? internal::Score() : internal::score_on_lattice(scorer), options);
}

}  // namespace

ErrorStatistics evaluate(const Lens& source, const Projection& target, const FieldOfView& field_of_view,
                         const EvaluateOptions& options) {
  return evaluate_all(internal::Scorer(source, nullptr, &target, field_of_view, options.target_max_angle_rad), options);
}

ErrorStatistics evaluate(const Lens& source, const CameraModel& target, const FieldOfView& field_of_view,
                         const EvaluateOptions& options) {
  return evaluate_all(internal::Scorer(source, &target, nullptr, field_of_view, options.target_max_angle_rad), options);
}

}  // namespace fca
