// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/judge.h>

#include "judge_lattice.h"
#include "judge_maximum.h"
#include "judge_stages.h"
#include "judge_summary.h"

namespace fca {

namespace internal {

Score score_on_lattice(const Scorer& scorer) {
  constexpr int kBinsPerOctave = 16;
  const std::vector<Point> points = score_lattice(scorer);
  Summary summary(kBinsPerOctave);
  summary.add(points);
  return {summary.judgement(scorer.domain(), points), summary.worst()};
}

Score score_every_pixel(const Scorer& scorer) {
  constexpr int kBinsPerOctave = 1024;  // percentiles to 0.1 %
  Summary summary(kBinsPerOctave);
  const ImageSize& size = scorer.domain().size;
  std::vector<Point> row(static_cast<std::size_t>(size.width));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      Point& point = row[static_cast<std::size_t>(x)];
      point.pixel = {static_cast<double>(x), static_cast<double>(y)};
      point.weight = 1.0;
    }
    scorer.score(row);
    summary.add(row);
  }
  Score score{summary.judgement(scorer.domain()), summary.worst()};
  Coverage& coverage = score.judgement.coverage;
  coverage.scored_pixels = summary.count(Verdict::kScored);
  coverage.outside_lens_pixels = summary.count(Verdict::kOutsideLens);
  coverage.unrepresentable_pixels = summary.count(Verdict::kUnrepresentable);
  return score;
}

}  // namespace internal

namespace {

Judgement judge_all(const internal::Scorer& scorer, const JudgeOptions& options) {
  internal::Score score = options.every_pixel ? score_every_pixel(scorer) : score_on_lattice(scorer);
  internal::find_maximum(scorer, score.worst, options.bound, score.judgement);
  return std::move(score.judgement);
}

}  // namespace

Judgement judge(const Lens& source, const Projection& target, const Domain& domain, const JudgeOptions& options) {
  return judge_all(internal::Scorer(source, nullptr, &target, domain, options.target_reach_rad), options);
}

Judgement judge(const Lens& source, const CameraModel& target, const Domain& domain, const JudgeOptions& options) {
  return judge_all(internal::Scorer(source, &target, nullptr, domain, options.target_reach_rad), options);
}

}  // namespace fca
