// SPDX-License-Identifier: BSD-3-Clause
#include "judge_maximum.h"

#include "bound.h"
#include "lens_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fca::internal {

/// Along eight directions, with steps down to a thousandth of a pixel.
Point climb(const Scorer& scorer, const Pixel& start) {
  constexpr double kFinestStep = 1e-3;      // px
  constexpr std::size_t kMostPoints = 600;  // along a ring of nearly equal errors it would never end
  constexpr double kDiagonal = 0.7071067811865476;
  constexpr std::array<Pixel, 8> kDirections = {{{1, 0},
                                                 {-1, 0},
                                                 {0, 1},
                                                 {0, -1},
                                                 {kDiagonal, kDiagonal},
                                                 {-kDiagonal, kDiagonal},
                                                 {kDiagonal, -kDiagonal},
                                                 {-kDiagonal, -kDiagonal}}};
  const ImageSize& size = scorer.domain().size;
  const Pixel last = {size.width - 1.0, size.height - 1.0};
  Point best = scorer.at(start);
  std::size_t points = 0;
  std::array<Point, kDirections.size()> around;
  for (double step = std::max(last[0], last[1]) / 64.0; step > kFinestStep && points < kMostPoints; points += around.size()) {
    for (std::size_t i = 0; i < around.size(); ++i) {
      around[i].pixel = {std::clamp(best.pixel[0] + step * kDirections[i][0], 0.0, last[0]),
                         std::clamp(best.pixel[1] + step * kDirections[i][1], 0.0, last[1])};
    }
    scorer.score(around);
    bool moved = false;
    for (const Point& next : around) {
      if (next.verdict != Verdict::kScored || !(next.error > best.error)) continue;
      best = next;
      moved = true;
    }
    if (!moved) step *= 0.5;
  }
  return best;
}

namespace {

void keep_if_worse(const Point& point, Judgement& result) {
  if (point.verdict != Verdict::kScored || point.error < result.error.max) return;
  result.error.max = point.error;
  result.error.max_at = point.pixel;
  constexpr double kBandRadians = 10.0 * std::numbers::pi / 180.0;
  const auto band = static_cast<std::size_t>(std::acos(std::clamp(point.cosine, -1.0, 1.0)) / kBandRadians);
  if (band < result.bands.size()) result.bands[band].max_px = std::max(result.bands[band].max_px, point.error);
}

/// The worst point of an edge: a candidate for the maximum.
Point worst_point(const LensEdge& edge) {
  constexpr int kAzimuths = 120;
  constexpr double kSpacing = 2.0 * std::numbers::pi / kAzimuths;
  Point worst;
  double azimuth = 0.0;
  const auto keep_if_worse_at = [&](double candidate) {
    const Point point = edge(candidate);
    if (point.verdict != Verdict::kScored || (worst.verdict == Verdict::kScored && point.error <= worst.error)) return false;
    worst = point;
    azimuth = candidate;
    return true;
  };
  for (int i = 0; i < kAzimuths; ++i) keep_if_worse_at(kSpacing * i);
  constexpr double kFinest = 1e-6;
  for (double step = 0.5 * kSpacing; worst.verdict == Verdict::kScored && step > kFinest;) {
    if (!keep_if_worse_at(azimuth + step) && !keep_if_worse_at(azimuth - step)) step *= 0.5;
  }
  return worst;
}

/// Climbs from the points, the worst first, but not twice up the same hill.
void climb_from(const Scorer& scorer, std::span<const Point> points, std::size_t most, Judgement& result) {
  const ImageSize& size = scorer.domain().size;
  const double apart = std::max(size.width, size.height) / 20.0;
  std::vector<Pixel> climbed;
  for (const Point& point : points) {
    if (climbed.size() >= most) return;
    const bool known = std::ranges::any_of(
        climbed, [&](const Pixel& other) { return std::hypot(point.pixel[0] - other[0], point.pixel[1] - other[1]) < apart; });
    if (known) continue;
    climbed.push_back(point.pixel);
    const Point top = climb(scorer, point.pixel);
    climbed.push_back(top.pixel);
    keep_if_worse(top, result);
  }
}

}  // namespace

/// Without a bound, climbing from the worst points and along the edge of the lens is all there is. With one, the search for it
/// looks everywhere: it starts from the worst hill and ends at most 1 % below the maximum, and one more climb leads up there. A
/// climb does not follow the rim of a circle: that is looked along, too.
void find_maximum(const Scorer& scorer, std::span<const Point> worst, bool prove, Judgement& result) {
  if (worst.empty()) return;
  constexpr std::size_t kAll = 12;
  constexpr std::size_t kFew = 4;
  const CameraModel* source = scorer.source().model();
  const bool provable = prove && source != nullptr && scorer.target() != nullptr;
  climb_from(scorer, worst, provable ? kFew : kAll, result);
  // Where the source is no model, its edge is where climbing ends, too.
  if (source != nullptr && (!provable || scorer.domain().circle)) {
    for (const LensEdge& edge : lens_edges(scorer)) {
      if (const Point point = worst_point(edge); point.verdict == Verdict::kScored)
        keep_if_worse(climb(scorer, point.pixel), result);
    }
  }
  if (!provable) return;
  const double climbed = result.error.max;
  const ErrorBound proof = bound_error(*source, *scorer.target(), scorer.domain(), scorer.target_reach_rad(), climbed);
  if (proof.seen > climbed) {
    keep_if_worse(climb(scorer, proof.seen_at), result);
  }
  // What was measured is an error, too, even where rounding had its part in it.
  result.error.bound = std::max(proof.bound, result.error.max);
}

}  // namespace fca::internal
