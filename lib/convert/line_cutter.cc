// SPDX-License-Identifier: BSD-3-Clause
#include "line_cutter.h"

#include "judge_summary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::internal {

namespace {

constexpr double kBandRad = Summary::kBandDegrees * std::numbers::pi / 180.0;

/// Sine of half an angle from the axis: along a line of an image it is nearly linear.
double half_sine(double cosine) { return std::sqrt(std::max(0.0, 0.5 - 0.5 * cosine)); }
/// Where there is no ray: more than any half sine.
constexpr double kNone = 2.0;

double edge_at(double angle) { return angle < std::numbers::pi ? half_sine(std::cos(angle)) : 1.0; }

}  // namespace

LineCutter::LineCutter(const Scorer& scorer)
    : scorer_(scorer),
      lens_(edge_at(scorer.domain().max_angle_rad)),
      scored_(std::min(lens_, edge_at(scorer.target_reach_rad()))) {
  const double last = scorer.domain().max_angle_rad;
  for (double angle = kBandRad; angle < last; angle += kBandRad) borders_.push_back(edge_at(angle));
  for (const double edge : {scored_, lens_}) {
    if (edge < 1.0) borders_.push_back(edge);
  }
  std::ranges::sort(borders_);
}

void LineCutter::look_along(std::span<const Line> lines) {
  seen_.resize(lines.size() * (kSteps + 1));
  Batch batch;
  std::size_t first = 0;
  std::size_t count = 0;
  const auto finish = [&] {
    scorer_.find_rays(batch, count);
    for (std::size_t i = 0; i < count; ++i) {
      seen_[first + i] = batch.z[i] == kNoRay        ? kNone
                         : std::isfinite(batch.z[i]) ? half_sine(batch.z[i])
                                                     : ask({batch.u[i], batch.v[i]});
    }
    first += count;
    count = 0;
  };
  for (const Line& line : lines) {
    for (std::size_t step = 0; step <= kSteps; ++step) {
      const Pixel pixel = line.at(static_cast<double>(step) / kSteps);
      batch.u[count] = pixel[0];
      batch.v[count] = pixel[1];
      if (++count == Batch::kSize) finish();
    }
  }
  finish();
}

std::span<const LineCutter::Piece> LineCutter::pieces(std::size_t i, const Line& line) {
  pieces_.clear();
  begin_ = 0.0;
  lit_ = lit_part(line);
  const std::span<double> seen = std::span(seen_).subspan(i * (kSteps + 1), kSteps + 1);
  for (std::size_t step = 0; step < kSteps; ++step) cut_step(line, seen, step);
  end_piece(1.0, seen[kSteps] <= scored_);
  return pieces_;
}

LineCutter::LitSpan LineCutter::lit_part(const Line& line) const {
  const std::optional<LensCircle>& circle = scorer_.domain().circle;
  if (!circle) return {0.0, 1.0};
  const std::array<double, 2> way = {line.to[0] - line.from[0], line.to[1] - line.from[1]};
  const std::array<double, 2> start = {line.from[0] - circle->centre[0], line.from[1] - circle->centre[1]};
  const double square = way[0] * way[0] + way[1] * way[1];
  const double nearest = -(way[0] * start[0] + way[1] * start[1]) / square;
  const double across = (way[0] * start[1] - way[1] * start[0]) / square;
  const double half = circle->radius_px * circle->radius_px / square - across * across;
  if (!(half > 0.0)) return {1.0, 0.0};
  return {nearest - std::sqrt(half), nearest + std::sqrt(half)};
}

double LineCutter::ask(const Pixel& pixel) const {
  const std::optional<Ray> ray = scorer_.source().ray(pixel);
  return ray ? half_sine((*ray)[2]) : kNone;
}

void LineCutter::cut_step(const Line& line, std::span<double> seen, std::size_t i) {
  Step step = {static_cast<double>(i) / kSteps, static_cast<double>(i + 1) / kSteps, seen[i], seen[i + 1], 0.0};
  if (step.from == kNone && step.to == kNone) return;
  if (step.from == kNone) {
    find_last_ray(line, step.end, step.begin, step.from);
    end_piece(step.begin, false);
  } else if (step.to == kNone) {
    if (i > 1) {
      step.bend = seen[i] - 2.0 * seen[i - 1] + seen[i - 2];
      step.to = 2.0 * seen[i] - seen[i - 1] + step.bend;
    }
    if (!end_at_lens(line, step)) {
      step.bend = 0.0;
      find_last_ray(line, step.begin, step.end, step.to);
    }
  } else if (const std::size_t middle = std::clamp<std::size_t>(i, 1, kSteps - 1);
             seen[middle - 1] != kNone && seen[middle + 1] != kNone) {
    step.bend = seen[middle + 1] - 2.0 * seen[middle] + seen[middle - 1];
  }
  if (step.from < step.to) {
    for (auto border = std::ranges::upper_bound(borders_, step.from); border != borders_.end() && *border <= step.to; ++border)
      end_piece(place_of(line, step, *border), *border <= scored_);
  } else {
    for (auto border = std::ranges::upper_bound(borders_, step.from);
         border != borders_.begin() && *std::prev(border) > step.to;) {
      --border;
      end_piece(place_of(line, step, *border), *border < scored_);
    }
  }
  if (seen[i + 1] == kNone && step.to <= lens_) end_piece(step.end, step.to <= scored_);
}

std::optional<double> LineCutter::crossing_of_edge(const Line& line, const Step& step, double edge) const {
  constexpr double kClose = 0.01;  // of a half sine
  constexpr double kFine = 1e-3;   // of a line; the next step would be a tenth of that
  const double whole = step.end - step.begin;
  double at = step.crossing(edge);
  double slope = (step.to - step.from + ((at - step.begin) / whole - 0.5) * step.bend) / whole;
  double before = at;
  double seen = kNone;
  constexpr int kMostRounds = 8;
  for (int round = 0; round < kMostRounds; ++round) {
    const double found = ask(line.at(at));
    if (!(std::abs(found - edge) < kClose)) return std::nullopt;
    if (seen != kNone && found != seen) slope = (found - seen) / (at - before);
    before = at;
    seen = found;
    at += (edge - found) / slope;
    if (!(at > step.begin && at <= step.end)) return std::nullopt;
    if (std::abs(at - before) < kFine) return at;
  }
  return std::nullopt;
}

bool LineCutter::end_at_lens(const Line& line, Step& step) const {
  if (step.to == kNone || !(step.to > lens_)) return false;
  const std::optional<double> at = crossing_of_edge(line, step, lens_);
  if (!at) return false;
  const double share = (*at - step.begin) / (step.end - step.begin);
  step = {step.begin, *at, step.from, lens_, step.bend * share * share};
  return true;
}

void LineCutter::find_last_ray(const Line& line, double there, double& none, double& seen) const {
  constexpr int kHalvings = 12;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (there + none);
    if (const double found = ask(line.at(middle)); found <= lens_) {
      there = middle;
      seen = found;
    } else {
      none = middle;
    }
  }
  none = there;
}

}  // namespace fca::internal
