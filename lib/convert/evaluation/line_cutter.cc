// SPDX-License-Identifier: BSD-3-Clause
#include "line_cutter.h"

#include "summary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::internal {

namespace {

constexpr double kBandRad = Summary::kBandDegrees * std::numbers::pi / 180.0;

/// The half sine of an angle with this cosine.
double half_sine(double cosine) { return std::sqrt(std::max(0.0, 0.5 - 0.5 * cosine)); }

/// The value for a pixel without a ray. It is larger than any half sine.
constexpr double kNoHalfSine = 2.0;

/// The number of times that a step of a line is halved in a search, which is exact to 1/20 px on a line of 2,500 px.
constexpr int kHalvings = 12;

/// The half sine of an angle from the axis [rad]; 1, the largest half sine, for all angles from pi on.
double half_sine_of_angle(double angle) { return angle < std::numbers::pi ? half_sine(std::cos(angle)) : 1.0; }

}  // namespace

LineCutter::LineCutter(const Scorer& scorer)
    : scorer_(scorer),
      field_of_view_half_sine_(half_sine_of_angle(scorer.field_of_view().max_angle_rad)),
      scored_half_sine_(std::min(field_of_view_half_sine_, half_sine_of_angle(scorer.target_max_angle_rad()))) {
  const double last = scorer.field_of_view().max_angle_rad;
  std::vector<double> angles = {std::min(last, scorer.target_max_angle_rad()), last};
  for (double angle = kBandRad; angle < last; angle += kBandRad) angles.push_back(angle);
  radial_ = RadialBorders::of(scorer.source(), angles);
  if (radial_) return;
  for (const double angle : angles) {
    if (const double edge = half_sine_of_angle(angle); edge < 1.0) borders_.push_back(edge);
  }
  std::ranges::sort(borders_);
}

void LineCutter::sample_lines(std::span<const Line> lines) {
  if (radial_) return;
  half_sines_.resize(lines.size() * (kSteps + 1));
  Batch batch;
  std::size_t first = 0;
  std::size_t count = 0;
  const auto finish = [&] {
    scorer_.find_rays(batch, count);
    for (std::size_t i = 0; i < count; ++i) {
      half_sines_[first + i] = batch.z[i] == kNoRay        ? kNoHalfSine
                               : std::isfinite(batch.z[i]) ? half_sine(batch.z[i])
                                                           : half_sine_at({batch.u[i], batch.v[i]});
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
  in_circle_ = part_in_circle(line);
  if (radial_) {
    cut_at_radii(line);
    return pieces_;
  }
  const std::span<double> half_sines = std::span(half_sines_).subspan(i * (kSteps + 1), kSteps + 1);
  for (std::size_t step = 0; step < kSteps; ++step) cut_step(line, half_sines, step);
  end_piece(1.0, half_sines[kSteps] <= scored_half_sine_);
  return pieces_;
}

void LineCutter::cut_at_radii(const Line& line) {
  const LineAmongCircles among_circles = radial_->among_circles(line);
  const std::span<const double> radii = radial_->radii();
  const LineSpan scored = among_circles.inside(radii.front());
  places_.clear();
  const auto cut_at_ends = [this](const LineSpan& span) {
    for (const double place : {span.begin, span.end}) {
      if (place > 0.0 && place < 1.0) places_.push_back(place);
    }
  };
  cut_at_ends(in_circle_);
  for (const double radius : radii) cut_at_ends(among_circles.inside(radius));
  std::ranges::sort(places_);
  places_.push_back(1.0);
  for (const double place : places_) add_piece(place, scored.holds(0.5 * (begin_ + place)));
}

LineSpan LineCutter::part_in_circle(const Line& line) const {
  const std::optional<LensCircle>& circle = scorer_.field_of_view().circle;
  if (!circle) return {0.0, 1.0};
  return LineAmongCircles({line.from[0] - circle->centre[0], line.from[1] - circle->centre[1]},
                          {line.to[0] - line.from[0], line.to[1] - line.from[1]})
      .inside(circle->radius_px);
}

double LineCutter::half_sine_at(const Pixel& pixel) const {
  const std::optional<Ray> ray = scorer_.source().ray(pixel);
  return ray ? half_sine((*ray)[2]) : kNoHalfSine;
}

void LineCutter::cut_step(const Line& line, std::span<double> half_sines, std::size_t i) {
  Step step = {static_cast<double>(i) / kSteps, static_cast<double>(i + 1) / kSteps, half_sines[i], half_sines[i + 1], 0.0};
  if (step.from == kNoHalfSine && step.to == kNoHalfSine) return;
  if (step.from == kNoHalfSine) {  // the rays begin inside the step
    find_last_ray(line, step.end, step.begin, step.from);
    step.steep = true;
    end_piece(step.begin, false);
  } else if (step.to == kNoHalfSine) {  // the rays end inside the step: extrapolates the parabola to its end
    if (i > 1) {
      step.bend = half_sines[i] - 2.0 * half_sines[i - 1] + half_sines[i - 2];
      step.to = 2.0 * half_sines[i] - half_sines[i - 1] + step.bend;
    }
    if (!end_at_field_of_view(line, step)) {
      step.bend = 0.0;
      step.steep = true;
      find_last_ray(line, step.begin, step.end, step.to);
    }
  } else if (const std::size_t middle = std::clamp<std::size_t>(i, 1, kSteps - 1);
             half_sines[middle - 1] != kNoHalfSine && half_sines[middle + 1] != kNoHalfSine) {
    step.bend = half_sines[middle + 1] - 2.0 * half_sines[middle] + half_sines[middle - 1];
  }
  // Cuts the line at the borders between the half sines of the step, in the order in which the line crosses them.
  if (step.from < step.to) {
    for (auto border = std::ranges::upper_bound(borders_, step.from); border != borders_.end() && *border <= step.to; ++border)
      end_piece(place_of(line, step, *border), *border <= scored_half_sine_);
  } else {
    for (auto border = std::ranges::upper_bound(borders_, step.from);
         border != borders_.begin() && *std::prev(border) > step.to;) {
      --border;
      end_piece(place_of(line, step, *border), *border < scored_half_sine_);
    }
  }
  if (half_sines[i + 1] == kNoHalfSine && step.to <= field_of_view_half_sine_)
    end_piece(step.end, step.to <= scored_half_sine_);
}

std::optional<double> LineCutter::crossing_of_edge(const Line& line, const Step& step, double edge) const {
  constexpr double kLargestMiss = 0.01;    // of half sines; with a larger difference from `edge`, the parabola is no use
  constexpr double kLastMove = 1e-3;       // as a fraction of the line; the next step would be a tenth of this
  constexpr double kLastFirstMove = 1e-5;  // the same for the first step, whose derivative is only estimated
  const double whole = step.end - step.begin;
  double at = step.crossing(edge);
  double derivative = (step.to - step.from + ((at - step.begin) / whole - 0.5) * step.bend) / whole;
  double before = at;
  double half_sine_before = kNoHalfSine;
  constexpr int kMostIterations = 8;
  for (int round = 0; round < kMostIterations; ++round) {
    const double found = half_sine_at(line.at(at));
    if (!(std::abs(found - edge) < kLargestMiss)) return std::nullopt;
    if (half_sine_before != kNoHalfSine && found != half_sine_before) derivative = (found - half_sine_before) / (at - before);
    before = at;
    half_sine_before = found;
    at += (edge - found) / derivative;
    if (!(at > step.begin && at <= step.end)) return std::nullopt;
    if (std::abs(at - before) < (round == 0 ? kLastFirstMove : kLastMove)) return at;
  }
  return std::nullopt;
}

bool LineCutter::end_at_field_of_view(const Line& line, Step& step) const {
  if (step.to == kNoHalfSine || !(step.to > field_of_view_half_sine_)) return false;
  const std::optional<double> at = crossing_of_edge(line, step, field_of_view_half_sine_);
  if (!at) return false;
  const double share = (*at - step.begin) / (step.end - step.begin);
  step = {step.begin, *at, step.from, field_of_view_half_sine_, step.bend * share * share};
  return true;
}

double LineCutter::halve_to(const Line& line, double border, double inside, double outside) const {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    (half_sine_at(line.at(middle)) <= border ? inside : outside) = middle;
  }
  return inside;
}

void LineCutter::find_last_ray(const Line& line, double inside, double& place, double& last_half_sine) const {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (inside + place);
    if (const double found = half_sine_at(line.at(middle)); found <= field_of_view_half_sine_) {
      inside = middle;
      last_half_sine = found;
    } else {
      place = middle;
    }
  }
  place = inside;
}

}  // namespace fca::internal
