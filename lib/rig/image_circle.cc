// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/image_circle.h>

#include "circle_vote.h"
#include "rim_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace fca {

namespace {

using internal::Circle;
using internal::GreyView;
using internal::kDirections;
using internal::Levels;
using internal::parts_seen;
using internal::refined;
using internal::Steps;
using internal::steps_from_dark;
using internal::steps_on;
using internal::vote;

constexpr double kSharp = 0.6;

/// Could a lens with its axis there be in front of this image with such a circle?
bool is_plausible(const Circle& circle, const GreyView& view, const Pixel& axis) {
  const double side = std::min(view.image().width, view.image().height);
  constexpr double kSmallest = 0.1;
  constexpr double kLargest = 4.0;
  constexpr double kFurthestOff = 0.5;
  return view.inside(circle.centre) && circle.radius > kSmallest * side && circle.radius < kLargest * side &&
         std::hypot(circle.centre[0] - axis[0], circle.centre[1] - axis[1]) < kFurthestOff * circle.radius;
}

/// How much of what lies beyond the circle is dark; nothing if next to nothing lies there.
std::optional<double> dark_share_beyond(const Circle& circle, const GreyView& view, const Levels& levels) {
  constexpr double kBlur = 3.0;  // px
  constexpr double kNextToNothing = 5e-4;
  const GreyImage& image = view.image();
  std::ptrdiff_t beyond = 0;
  std::ptrdiff_t dark = 0;
  const auto is_dark = [&levels](float sample) { return sample <= levels.threshold; };
  for (int row = 0; row < image.height; ++row) {
    const auto samples = image.samples.begin() + std::ptrdiff_t{row} * image.width;
    const auto count = [&](int from, int to) {
      for (int column = from; column < to; ++column) {
        if (circle.distance({static_cast<double>(column), static_cast<double>(row)}) <= kBlur) continue;
        ++beyond;
        if (is_dark(samples[column])) ++dark;
      }
    };
    // A chord of the circle about the same centre that is larger by the blur. A pixel and more from its ends no distance need
    // be computed.
    const double off = row - circle.centre[1];
    const double half = std::sqrt(std::max(0.0, std::pow(circle.radius + kBlur, 2) - off * off));
    const auto in_image = [&image](double column) {
      return static_cast<int>(std::clamp(column, 0.0, static_cast<double>(image.width)));
    };
    const int left = in_image(std::floor(circle.centre[0] - half) - 1.0);
    const int right = std::max(left, in_image(std::ceil(circle.centre[0] + half) + 2.0));
    const int inside = std::clamp(in_image(std::ceil(circle.centre[0] - half) + 2.0), left, right);
    const int inside_end = std::clamp(in_image(std::floor(circle.centre[0] + half) - 1.0), inside, right);
    beyond += left + (image.width - right);
    dark += std::count_if(samples, samples + left, is_dark) + std::count_if(samples + right, samples + image.width, is_dark);
    count(left, inside);
    count(inside_end, right);
  }
  if (static_cast<double>(beyond) < kNextToNothing * static_cast<double>(image.samples.size())) return std::nullopt;
  return static_cast<double>(dark) / static_cast<double>(beyond);
}

/// What the light falls by at the rim, of what it falls by around it, where steps lie on it.
double sharpness_of(const Circle& circle, const std::vector<Pixel>& on, const GreyView& view) {
  const double near = std::max(4.0, 0.02 * circle.radius);
  const double around = 5.0 * near;
  double at_rim = 0.0;
  double in_all = 0.0;
  for (const Pixel& step : on) {
    const Pixel way = {(step[0] - circle.centre[0]) / circle.radius, (step[1] - circle.centre[1]) / circle.radius};
    const auto value = [&](double outwards) {
      const Pixel pixel = {step[0] + outwards * way[0], step[1] + outwards * way[1]};
      return view.inside(pixel) ? std::optional(view.value(pixel)) : std::nullopt;
    };
    const std::optional<double> beyond = value(near);
    const std::optional<double> far_beyond = value(around);
    const std::optional<double> inside = value(-near);
    const std::optional<double> far_inside = value(-around);
    if (!beyond || !far_beyond || !inside || !far_inside) continue;
    at_rim += std::max(0.0, *inside - *beyond);
    in_all += std::max(0.0, std::max(*inside, *far_inside) - std::min(*beyond, *far_beyond));
  }
  return in_all > 0.0 ? at_rim / in_all : 0.0;
}

/// The share of the rim inside the image that the steps confirm, and how far these are from it.
LensCircle confirmed(const Circle& circle, const std::vector<Steps>& all, const GreyView& view) {
  LensCircle result{circle.centre, circle.radius, 0.0, 0.0, {}, 0.0};
  const std::vector<Pixel> on = steps_on(circle, all);
  for (const Pixel& step : on) result.rms_px += circle.distance(step) * circle.distance(step) / static_cast<double>(on.size());
  result.rms_px = std::sqrt(result.rms_px);
  int visible = 0;
  for (int k = 0; k < kDirections; ++k) visible += view.inside(result.rim(2.0 * std::numbers::pi * k / kDirections));
  result.sharpness = sharpness_of(circle, on, view);
  if (visible > 0) result.rim_share = std::min(1.0, static_cast<double>(parts_seen(circle, on)) / visible);
  return result;
}

/// With what is brighter than the threshold as lit; nothing of whose rim less than that share is seen.
std::optional<LensCircle> find_at(const GreyView& view, const Levels& levels, const Pixel& axis, double least_of_rim) {
  const auto plausible = [&](const Circle& circle) { return is_plausible(circle, view, axis); };
  std::vector<Steps> steps = steps_from_dark(view, levels, axis);
  std::optional<Circle> circle = vote(steps, plausible);
  if (!circle) return std::nullopt;
  // Seen from its own centre each direction meets the rim at right angles.
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) {
    circle = refined(*circle, steps);
    if (!plausible(*circle)) return std::nullopt;
    steps = steps_from_dark(view, levels, circle->centre);
  }
  circle = refined(*circle, steps);
  if (!plausible(*circle)) return std::nullopt;
  const LensCircle result = confirmed(*circle, steps, view);
  constexpr double kMostlyDark = 0.7;  // the rest is flare
  const std::optional<double> dark = dark_share_beyond(*circle, view, levels);
  if (result.rim_share < least_of_rim || !dark || *dark < kMostlyDark) return std::nullopt;
  return result;
}

/// Does the first tell more of a lens's rim?
bool is_better(const LensCircle& one, const LensCircle& other) {
  const bool sharp = one.sharpness >= kSharp;
  if (sharp != (other.sharpness >= kSharp)) return sharp;
  return one.rim_share > other.rim_share;
}

bool is_same(const LensCircle& one, const LensCircle& other) {
  constexpr double kSame = 0.015;  // of the radius
  const double apart = std::hypot(one.centre[0] - other.centre[0], one.centre[1] - other.centre[1]);
  return std::max(apart, std::abs(one.radius_px - other.radius_px)) <= kSame * other.radius_px;
}

/// With these levels, and with brighter ones where what they show is not sharp.
std::optional<LensCircle> find_by(const GreyView& view, const Levels& levels, const Pixel& axis) {
  constexpr double kLeastOfRim = 0.12;
  std::optional<LensCircle> found = find_at(view, levels, axis, kLeastOfRim);
  // A glow beyond the rim is dark, too, as soon as more counts as dark. What is bright inside the lens is no larger circle.
  constexpr std::array<float, 4> kShares = {0.1F, 0.2F, 0.35F, 0.5F};
  constexpr double kMuchSmaller = 0.7;
  constexpr double kMoreOfRim = 0.3;  // bright parts of a scene have edges, too
  for (const float share : kShares) {
    if (found && found->sharpness >= kSharp) break;
    const float threshold = levels.black + share * (levels.bright - levels.black);
    if (threshold <= levels.threshold) continue;
    const std::optional<LensCircle> other = find_at(view, {levels.black, levels.bright, threshold}, axis, kMoreOfRim);
    if (!other) continue;
    if (!found || (is_better(*other, *found) && other->radius_px > kMuchSmaller * found->radius_px)) found = other;
  }
  return found;
}

}  // namespace

GreyImage brightest(std::span<const GreyImage> images) {
  GreyImage result = images.front();
  for (const GreyImage& image : images.subspan(1)) {
    result.full_scale = std::max(result.full_scale, image.full_scale);
    std::ranges::transform(result.samples, image.samples, result.samples.begin(),
                           [](float a, float b) { return std::max(a, b); });
  }
  return result;
}

std::optional<LensCircle> find_image_circle(const GreyImage& image, const Pixel& principal_point) {
  constexpr int kSmallest = 16;  // px
  if (image.width < kSmallest || image.height < kSmallest) return std::nullopt;
  const GreyImage smooth = internal::smoothed(image);
  const GreyView view(smooth);
  const Pixel axis = {std::clamp(principal_point[0], 0.0, image.width - 1.0),
                      std::clamp(principal_point[1], 0.0, image.height - 1.0)};
  // Of a small lens little is bright; of a large one that would be the lamps in the scene.
  constexpr std::array<double, 2> kBrightShares = {0.05, 0.01};
  for (const double share : kBrightShares) {
    const std::optional<Levels> levels = internal::levels_of(view, share);
    if (!levels) continue;
    if (const std::optional<LensCircle> found = find_by(view, *levels, axis)) return found;
  }
  return std::nullopt;
}

void ImageCircleSearch::add(const GreyImage& image) {
  alone_.push_back(find_image_circle(image, principal_point_));
  together_ = together_ ? brightest(std::array{*std::move(together_), image}) : image;
}

std::optional<LensCircle> ImageCircleSearch::best() const {
  std::vector<LensCircle> found;
  for (const std::optional<LensCircle>& circle : alone_) {
    if (circle) found.push_back(*circle);
  }
  if (alone_.size() > 1) {
    if (const std::optional<LensCircle> together = find_image_circle(*together_, principal_point_)) found.push_back(*together);
  }
  // One image by itself proves no other wrong.
  const auto witnesses = [this](const LensCircle& circle) { return std::max<std::size_t>(showing(circle).size(), 1); };
  std::optional<LensCircle> best;
  for (const LensCircle& circle : found) {
    const std::size_t more = best ? witnesses(*best) : 0;
    if (witnesses(circle) > more || (witnesses(circle) == more && is_better(circle, *best))) best = circle;
  }
  return best;
}

std::vector<std::size_t> ImageCircleSearch::showing(const LensCircle& circle) const {
  std::vector<std::size_t> images;
  for (std::size_t i = 0; i < alone_.size(); ++i) {
    if (alone_[i] && is_same(*alone_[i], circle)) images.push_back(i);
  }
  return images;
}

std::vector<std::size_t> ImageCircleSearch::contradicting(const LensCircle& circle) const {
  constexpr double kGoodPart = 0.3;
  std::vector<std::size_t> images;
  for (std::size_t i = 0; i < alone_.size(); ++i) {
    if (alone_[i] && alone_[i]->rim_share > kGoodPart && !is_same(*alone_[i], circle)) images.push_back(i);
  }
  return images;
}

}  // namespace fca
