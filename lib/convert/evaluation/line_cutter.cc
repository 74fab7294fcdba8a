// SPDX-License-Identifier: BSD-3-Clause
#include "line_cutter.h"

#include "summary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::internal {

namespace {

constexpr double kBandRad = Summary::kBandDegrees * std::numbers::pi / 180.0;

/// Sine of half the angle from the axis. Along a line of an image it is nearly linear, so that few steps find where it has a
/// given value.
double half_sine(double cosine) { return std::sqrt(std::max(0.0, 0.5 - 0.5 * cosine)); }
/// Stands for the half sine of a pixel without a ray: larger than any half sine.
constexpr double kNone = 2.0;

/// How often a step of a line is halved: that finds a place to 1/20 px on a line of 2,500 px.
constexpr int kHalvings = 12;

double edge_at(double angle) { return angle < std::numbers::pi ? half_sine(std::cos(angle)) : 1.0; }

}  // namespace

LineCutter::LineCutter(const Scorer& scorer)
    : scorer_(scorer),
      lens_(edge_at(scorer.field_of_view().max_angle_rad)),
      scored_(std::min(lens_, edge_at(scorer.target_max_angle_rad()))) {
  const double last = scorer.field_of_view().max_angle_rad;
  std::vector<double> angles = {std::min(last, scorer.target_max_angle_rad()), last};
  for (double angle = kBandRad; angle < last; angle += kBandRad) angles.push_back(angle);
  radial_ = RadialBorders::of(scorer.source(), angles);
  if (radial_) return;
  for (const double angle : angles) {
    if (const double edge = edge_at(angle); edge < 1.0) borders_.push_back(edge);
  }
  std::ranges::sort(borders_);
}

void LineCutter::look_along(std::span<const Line> lines) {
  if (radial_) return;
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
  lit_ = part_in_circle(line);
  if (radial_) {
    cut_at_radii(line);
    return pieces_;
  }
  const std::span<double> seen = std::span(seen_).subspan(i * (kSteps + 1), kSteps + 1);
  for (std::size_t step = 0; step < kSteps; ++step) cut_step(line, seen, step);
  end_piece(1.0, seen[kSteps] <= scored_);
  return pieces_;
}

void LineCutter::cut_at_radii(const Line& line) {
  const LinePast past = radial_->past(line);
  const std::span<const double> radii = radial_->radii();
  const LineSpan scored = past.inside(radii.front());
  places_.clear();
  const auto cut_at_ends = [this](const LineSpan& span) {
    for (const double place : {span.begin, span.end}) {
      if (place > 0.0 && place < 1.0) places_.push_back(place);
    }
  };
  cut_at_ends(lit_);
  for (const double radius : radii) cut_at_ends(past.inside(radius));
  std::ranges::sort(places_);
  places_.push_back(1.0);
  for (const double place : places_) add_piece(place, scored.holds(0.5 * (begin_ + place)));
}

LineSpan LineCutter::part_in_circle(const Line& line) const {
  const std::optional<LensCircle>& circle = scorer_.field_of_view().circle;
  if (!circle) return {0.0, 1.0};
  return LinePast({line.from[0] - circle->centre[0], line.from[1] - circle->centre[1]},
                  {line.to[0] - line.from[0], line.to[1] - line.from[1]})
      .inside(circle->radius_px);
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
    step.steep = true;
    end_piece(step.begin, false);
  } else if (step.to == kNone) {
    if (i > 1) {
      step.bend = seen[i] - 2.0 * seen[i - 1] + seen[i - 2];
      step.to = 2.0 * seen[i] - seen[i - 1] + step.bend;
    }
    if (!end_at_lens(line, step)) {
      step.bend = 0.0;
      step.steep = true;
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
  constexpr double kClose = 0.01;  // difference of half sines
  constexpr double kFine = 1e-3;   // fraction of the line: the next step would be a tenth of that
  constexpr double kVeryFine = 1e-5;
  const double whole = step.end - step.begin;
  double at = step.crossing(edge);
  double derivative = (step.to - step.from + ((at - step.begin) / whole - 0.5) * step.bend) / whole;
  double before = at;
  double seen = kNone;
  constexpr int kMostRounds = 8;
  for (int round = 0; round < kMostRounds; ++round) {
    const double found = ask(line.at(at));
    if (!(std::abs(found - edge) < kClose)) return std::nullopt;
    if (seen != kNone && found != seen) derivative = (found - seen) / (at - before);
    before = at;
    seen = found;
    at += (edge - found) / derivative;
    if (!(at > step.begin && at <= step.end)) return std::nullopt;
    if (std::abs(at - before) < (round == 0 ? kVeryFine : kFine)) return at;
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

double LineCutter::halve_to(const Line& line, double border, double inside, double outside) const {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    (ask(line.at(middle)) <= border ? inside : outside) = middle;
  }
  return inside;
}

void LineCutter::find_last_ray(const Line& line, double there, double& none, double& seen) const {
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
