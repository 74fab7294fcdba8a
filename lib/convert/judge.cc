// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/judge.h>

#include "judge_lattice.h"
#include "judge_maximum.h"
#include "judge_stages.h"
#include "judge_summary.h"

#include <algorithm>
#include <functional>

namespace fca {

namespace internal {

Score score_on_lattice(const Scorer& scorer) {
  constexpr int kBinsPerOctave = 64;
  Summary summary(kBinsPerOctave);
  score_lattice(scorer, [&](const Batch& batch, std::size_t count) { summary.add(batch, count); });
  return {summary.judgement(scorer.domain()), summary.worst()};
}

Score score_every_pixel(const Scorer& scorer) {
  constexpr int kBinsPerOctave = 1024;  // percentiles to 0.1 %
  Summary summary(kBinsPerOctave);
  const ImageSize& size = scorer.domain().size;
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
      summary.add(batch, count);
    }
  }
  Score score{summary.judgement(scorer.domain()), summary.worst()};
  Coverage& coverage = score.judgement.coverage;
  coverage.scored_pixels = summary.count(Verdict::kScored);
  coverage.outside_lens_pixels = summary.count(Verdict::kOutsideLens);
  coverage.unrepresentable_pixels = summary.count(Verdict::kUnrepresentable);
  // The worst place may lie between pixels, on the edge of a round domain, where the lattice has points.
  const std::vector<Point> beside = score_on_lattice(scorer).worst;
  score.worst.insert(score.worst.end(), beside.begin(), beside.end());
  std::ranges::sort(score.worst, std::ranges::greater{}, &Point::error);
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
