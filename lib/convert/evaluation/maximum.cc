// SPDX-License-Identifier: BSD-3-Clause
#include "maximum.h"

#include "../bound/bound.h"
#include "lens_edges.h"
#include "summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace fca::internal {

/// Compares the error in eight directions, with steps that shrink to 1e-3 px.
Point climb(const Scorer& scorer, const Pixel& start) {
  constexpr double kFinestStep = 1e-3;      // px
  constexpr std::size_t kMostPoints = 600;  // a climb along a ring of nearly equal errors would otherwise not end
  constexpr double kDiagonal = 0.7071067811865476;
  constexpr std::array<Pixel, 8> kDirections = {{{1, 0},
                                                 {-1, 0},
                                                 {0, 1},
                                                 {0, -1},
                                                 {kDiagonal, kDiagonal},
                                                 {-kDiagonal, kDiagonal},
                                                 {kDiagonal, -kDiagonal},
                                                 {-kDiagonal, -kDiagonal}}};
  const ImageSize& size = scorer.field_of_view().size;
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

/// The angle band of a point. Adds the band, with a share of 0, if the lattice has no point in it.
ErrorBand& band_of(const Point& point, std::vector<ErrorBand>& bands) {
  constexpr double kBandRadians = Summary::kBandDegrees * std::numbers::pi / 180.0;
  constexpr auto kLast = static_cast<std::size_t>(180.0 / Summary::kBandDegrees) - 1;
  const double angle = std::acos(std::clamp(point.cosine, -1.0, 1.0));
  const std::size_t band = std::min(kLast, static_cast<std::size_t>(angle / kBandRadians));
  while (bands.size() <= band) {
    const double from = Summary::kBandDegrees * static_cast<double>(bands.size());
    bands.push_back({from, from + Summary::kBandDegrees, 0.0, 0.0, 0.0});
  }
  return bands[band];
}

/// Makes the point the maximum of `result` and of its angle band if its error is at least as large as the maximum so far.
void keep_if_worse(const Point& point, ErrorStatistics& result) {
  if (point.verdict != Verdict::kScored || point.error < result.error.max) return;
  result.error.max = point.error;
  result.error.max_at = point.pixel;
  ErrorBand& band = band_of(point, result.bands);
  band.max_px = std::max(band.max_px, point.error);
  if (band.share == 0.0) band.rms_px = band.max_px;
}

/// The error of a point [px]; -1 if it is not scored.
double error_of(const Point& point) { return point.verdict == Verdict::kScored ? point.error : -1.0; }

/// Searches along an edge for a local maximum of the error, from the point `top` at the azimuth [rad]. `step`: the first step
/// [rad].
Point climb_along(const Scorer& scorer, const LensEdge& edge, double azimuth, double step, Point top) {
  constexpr double kFinest = 1e-5;  // rad
  while (step > kFinest) {
    bool moved = false;
    for (const double next : {azimuth + step, azimuth - step}) {
      const std::optional<Pixel> pixel = edge.at(next);
      const Point point = pixel ? scorer.at(*pixel) : Point();
      if (!(error_of(point) > error_of(top))) continue;
      top = point;
      azimuth = next;
      moved = true;
      break;
    }
    if (!moved) step *= 0.5;
  }
  return top;
}

/// An estimate of how far [px] the error may rise above `here`, the error of a point, between its two neighbours on an edge.
/// The maximum of a parabola through three errors of which the middle one is largest is at most 1/8 of their second difference
/// higher; the estimate is twice that. If a neighbour is not scored (negative), the error may double.
double possible_rise(double before, double here, double after) {
  constexpr double kSafety = 2.0;  // the error is no parabola
  if (before < 0.0 || after < 0.0) return here;
  return kSafety * 0.125 * std::abs(before - 2.0 * here + after);
}

/// The last point of an edge that is inside the image, between `azimuth` [rad], which is inside, and azimuth + `step`. A point
/// that is not scored if there is no such point.
Point end_of_edge(const Scorer& scorer, const LensEdge& edge, double azimuth, double step) {
  constexpr double kFinest = 1e-9;  // rad
  Point last;
  for (double move = 0.5 * step; std::abs(move) > kFinest; move *= 0.5) {
    const std::optional<Pixel> pixel = edge.at(azimuth + move);
    if (!pixel) continue;
    azimuth += move;
    last.pixel = *pixel;
    last.verdict = Verdict::kScored;
  }
  return last.verdict == Verdict::kScored ? scorer.at(last.pixel) : last;
}

/// Climbs from those points of an edge near which the error may be larger than the largest error found so far.
void climb_edge(const Scorer& scorer, const LensEdge& edge, ErrorStatistics& result) {
  constexpr int kAzimuths = 120;
  constexpr double kSpacing = 2.0 * std::numbers::pi / kAzimuths;
  const std::vector<Point> rim = points_of(scorer, edge, kAzimuths);
  const double highest = std::max(result.error.max, error_of(std::ranges::max(rim, {}, error_of)));
  Point best;
  const auto keep_worse = [&best](const Point& point) {
    if (error_of(point) > error_of(best)) best = point;
  };
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double here = error_of(rim[i]);
    const double before = error_of(rim[(i + rim.size() - 1) % rim.size()]);
    const double after = error_of(rim[(i + 1) % rim.size()]);
    if (here >= 0.0 && before < 0.0) keep_worse(end_of_edge(scorer, edge, kSpacing * static_cast<double>(i), -kSpacing));
    if (here >= 0.0 && after < 0.0) keep_worse(end_of_edge(scorer, edge, kSpacing * static_cast<double>(i), kSpacing));
    if (here < std::max(before, after) || here + possible_rise(before, here, after) < highest) continue;
    keep_worse(climb_along(scorer, edge, kSpacing * static_cast<double>(i), 0.5 * kSpacing, rim[i]));
  }
  if (best.verdict != Verdict::kScored) return;
  keep_if_worse(best, result);
  keep_if_worse(climb(scorer, best.pixel), result);
}

/// Climbs from at most `most` of the points, the worst first. Omits points near the start or the end of an earlier climb, and
/// points on an edge, because climb_edge() has searched the edges.
void climb_from(const Scorer& scorer, std::span<const Point> points, std::span<const LensEdge> edges, std::size_t most,
                ErrorStatistics& result) {
  const ImageSize& size = scorer.field_of_view().size;
  const double nearest = std::max(size.width, size.height) / 20.0;
  std::vector<Pixel> climbed;
  for (const Point& point : points) {
    if (climbed.size() >= most) return;
    if (std::ranges::any_of(edges, [&point](const LensEdge& edge) { return edge.passes(point); })) continue;
    const bool searched = std::ranges::any_of(climbed, [&](const Pixel& other) {
      return std::hypot(point.pixel[0] - other[0], point.pixel[1] - other[1]) < nearest;
    });
    if (searched) continue;
    climbed.push_back(point.pixel);
    const Point top = climb(scorer, point.pixel);
    climbed.push_back(top.pixel);
    keep_if_worse(top, result);
  }
}

}  // namespace

/// Climbs along the edges of the scored region, which climb() cannot follow, and from the worst points. The search for the
/// bound then covers the whole field of view. The largest error that it meets is at most 1 % below the maximum, and a climb
/// from there finds the maximum.
void find_maximum(const Scorer& scorer, std::span<const Point> worst, bool prove, ErrorStatistics& result) {
  if (worst.empty()) return;
  constexpr std::size_t kClimbs = 12;
  constexpr std::size_t kClimbsWithProof = 4;
  const CameraModel* source = scorer.source().model();
  const bool provable = prove && source != nullptr && scorer.target() != nullptr;
  // The edges of a source that is no model are not known, so that there is no climb along them.
  std::vector<LensEdge> edges;
  if (source != nullptr) edges = lens_edges(scorer);
  for (const LensEdge& edge : edges) climb_edge(scorer, edge, result);
  climb_from(scorer, worst, edges, provable ? kClimbsWithProof : kClimbs, result);
  if (!provable) return;
  const double climbed = result.error.max;
  const ErrorBound proof =
      bound_error(*source, *scorer.target(), scorer.field_of_view(), scorer.target_max_angle_rad(), climbed);
  if (proof.seen > climbed) {
    keep_if_worse(climb(scorer, proof.seen_at), result);
  }
  // By rounding, a measured error may be above the proven bound. The reported bound must not be smaller than it.
  result.error.bound = std::max(proof.bound, result.error.max);
}

}  // namespace fca::internal
