// SPDX-License-Identifier: BSD-3-Clause
// evaluate(), and the two stages of which it consists (stages.h).
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

/// Evaluates every pixel of the image and adds it to `summary`.
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

/// True if the maximum is so much larger than the rms that the sums over a lattice may be wrong: it has too few points in the
/// few places with large errors. The limit is higher for larger images, because evaluating every pixel of them takes long.
bool has_sharp_maximum(const ErrorSummary& error, const ImageSize& size) {
  constexpr long long kSmallImage = 500'000;          // pixels
  constexpr long long kLargestImage = 2'000'000;      // pixels; larger images are never evaluated at every pixel here
  constexpr double kLargestRatioInSmallImage = 15.0;  // of the maximum to the rms
  constexpr double kLargestRatio = 100.0;             // the same in other images
  constexpr double kNegligiblePx = 1e-6;
  const long long pixels = 1LL * size.width * size.height;
  return pixels <= kLargestImage && error.max > kNegligiblePx &&
         error.max > (pixels <= kSmallImage ? kLargestRatioInSmallImage : kLargestRatio) * error.rms;
}

/// Replaces the error statistics of the lattice by those of all pixels. Keeps the coverage, the bound, and the maximum if it is
/// larger than that of the pixels.
void sum_over_pixels(const Scorer& scorer, ErrorStatistics& statistics) {
  constexpr int kBinsPerOctave = 64;
  Summary summary(kBinsPerOctave);
  add_pixels(scorer, summary);
  const ErrorStatistics pixels = summary.statistics(scorer.field_of_view());
  if (pixels.coverage.scored == 0.0) return;
  const ErrorSummary before = statistics.error;
  statistics.error = pixels.error;
  statistics.error.bound = before.bound;
  if (before.max >= pixels.error.max) {
    statistics.error.max = before.max;
    statistics.error.max_at = before.max_at;
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
  const std::vector<Point> between = score_on_lattice(scorer).worst;
  score.worst.insert(score.worst.end(), between.begin(), between.end());
  std::ranges::sort(score.worst, std::ranges::greater{}, &Point::error);
  return score;
}

ErrorStatistics evaluate_all(const Scorer& scorer, Score lattice, const EvaluateOptions& options) {
  Score score = options.every_pixel ? score_every_pixel(scorer) : std::move(lattice);
  ErrorStatistics& statistics = score.statistics;
  find_maximum(scorer, score.worst, options.bound, statistics);
  if (!options.every_pixel && has_sharp_maximum(statistics.error, scorer.field_of_view().size))
    sum_over_pixels(scorer, statistics);
  return std::move(score.statistics);
}

}  // namespace internal

namespace {

/// Both stages.
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
