// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/lit_circle.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

namespace fca {

namespace {

constexpr int kDirections = 720;

/// What parts dark from light in an image.
struct Levels {
  float black = 0.0F;
  float threshold = 0.0F;
};

float percentile(std::vector<float> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

class View {
 public:
  explicit View(const GreyImage& image) : image_(image) {}

  [[nodiscard]] const GreyImage& image() const { return image_; }
  [[nodiscard]] float at(int column, int row) const {
    return image_
        .samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(column)];
  }
  [[nodiscard]] bool inside(const Pixel& pixel) const {
    return pixel[0] >= 0.0 && pixel[1] >= 0.0 && pixel[0] <= image_.width - 1.0 && pixel[1] <= image_.height - 1.0;
  }
  /// Between pixels, too; `pixel` is inside.
  [[nodiscard]] double value(const Pixel& pixel) const {
    const int column = std::min(static_cast<int>(pixel[0]), image_.width - 2);
    const int row = std::min(static_cast<int>(pixel[1]), image_.height - 2);
    const double s = pixel[0] - column;
    const double t = pixel[1] - row;
    return (1.0 - t) * ((1.0 - s) * at(column, row) + s * at(column + 1, row)) +
           t * ((1.0 - s) * at(column, row + 1) + s * at(column + 1, row + 1));
  }

 private:
  const GreyImage& image_;
};

/// From the darkest corner, whose noise is what dark is here, and from what is bright. Nothing if nothing is lit.
std::optional<Levels> levels_of(const View& view) {
  const GreyImage& image = view.image();
  const int side = std::max(3, std::min(image.width, image.height) / 24);
  std::optional<float> black;
  float noise = 0.0F;
  for (const int left : {0, image.width - side}) {
    for (const int top : {0, image.height - side}) {
      std::vector<float> corner;
      for (int row = top; row < top + side; ++row) {
        for (int column = left; column < left + side; ++column) corner.push_back(view.at(column, row));
      }
      const float median = percentile(corner, 0.5);
      if (black && median >= *black) continue;
      black = median;
      for (float& value : corner) value = std::abs(value - median);
      noise = 1.4826F * percentile(std::move(corner), 0.5);
    }
  }
  const float bright = percentile(image.samples, 0.95);
  constexpr float kTooDark = 0.02F;  // of the full scale: nothing can be told from the noise of a sensor
  if (!(bright - *black > kTooDark * image.full_scale)) return std::nullopt;
  constexpr float kNoises = 6.0F;
  constexpr float kShare = 0.06F;  // of the bright: where a vignette ends
  constexpr float kSteps = 2.5F / 255.0F;
  const float threshold = *black + std::max({kNoises * noise, kShare * (bright - *black), kSteps * image.full_scale});
  if (!(threshold < bright)) return std::nullopt;
  return Levels{*black, threshold};
}

/// A direction's steps from dark to light, from the border inwards.
using Steps = std::vector<Pixel>;

/// Where on the way in, from the first lit sample on, half the light is reached that falls a little further in: blur leaves
/// that where it is.
template <class Place>
double half_lit(const View& view, const Levels& levels, const Place& place, double first) {
  constexpr double kFurtherIn = 8.0;  // px
  const double end = std::max(first - kFurtherIn, 0.0);
  const double half = 0.5 * (levels.black + view.value(place(end)));
  double outer = view.value(place(first + 1.0));
  for (double t = first; t >= end; t -= 1.0) {
    const double inner = view.value(place(t));
    if (inner > half && outer <= half) return t + (inner - half) / (inner - outer);
    outer = inner;
  }
  return first + 0.5;
}

/// Of each direction from the centre. Light that begins at the image's border says nothing of a rim.
std::vector<Steps> steps_from_dark(const View& view, const Levels& levels, const Pixel& centre) {
  constexpr std::size_t kMost = 3;  // flare, its ghost, and the rim
  constexpr int kRun = 3;           // px: shorter ones are single hot or dead pixels
  std::vector<Steps> all(kDirections);
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kDirections;
    const Pixel way = {std::cos(angle), std::sin(angle)};
    const auto place = [&](double t) { return Pixel{centre[0] + t * way[0], centre[1] + t * way[1]}; };
    double end = 0.0;
    while (view.inside(place(end + 1.0))) end += 1.0;
    int dark = 0;
    int lit = 0;
    bool was_dark = false;
    for (double t = end; t >= 0.0 && all[static_cast<std::size_t>(k)].size() < kMost; t -= 1.0) {
      const bool is_lit = view.value(place(t)) > levels.threshold;
      dark = is_lit ? 0 : dark + 1;
      lit = is_lit ? lit + 1 : 0;
      if (dark >= kRun) was_dark = true;
      if (lit < kRun || !was_dark) continue;
      was_dark = false;
      all[static_cast<std::size_t>(k)].push_back(place(half_lit(view, levels, place, t + lit - 1.0)));
    }
  }
  return all;
}

struct Circle {
  Pixel centre{};
  double radius = 0.0;

  [[nodiscard]] double distance(const Pixel& pixel) const {
    return std::hypot(pixel[0] - centre[0], pixel[1] - centre[1]) - radius;
  }
};

std::optional<Circle> circle_through(const Pixel& a, const Pixel& b, const Pixel& c) {
  // The centre is as far from a as from b and c.
  Eigen::Matrix2d A;
  A << b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1];
  const auto half_square = [](const Pixel& p) { return 0.5 * (p[0] * p[0] + p[1] * p[1]); };
  const Eigen::Vector2d rhs(half_square(b) - half_square(a), half_square(c) - half_square(a));
  if (std::abs(A.determinant()) < 1.0) return std::nullopt;
  const Eigen::Vector2d centre = A.inverse() * rhs;
  return Circle{{centre[0], centre[1]}, std::hypot(a[0] - centre[0], a[1] - centre[1])};
}

/// Could a lens be in front of this image with such a circle?
bool plausible(const Circle& circle, const View& view) {
  const double side = std::min(view.image().width, view.image().height);
  constexpr double kSmallest = 0.1;
  constexpr double kLargest = 4.0;
  return view.inside(circle.centre) && circle.radius > kSmallest * side && circle.radius < kLargest * side;
}

double tolerance_of(const Circle& circle) { return std::max(1.5, 0.004 * circle.radius); }

/// The step of each direction that lies nearest to the circle, where one lies on it.
std::vector<Pixel> steps_on(const Circle& circle, const std::vector<Steps>& all) {
  std::vector<Pixel> found;
  const double tolerance = tolerance_of(circle);
  for (const Steps& steps : all) {
    const auto off = [&circle](const Pixel& step) { return std::abs(circle.distance(step)); };
    const auto nearest = std::ranges::min_element(steps, {}, off);
    if (nearest != steps.end() && off(*nearest) <= tolerance) found.push_back(*nearest);
  }
  return found;
}

/// In how many of as many equal parts of the rim there is a step. (Of steps alone there are many where an edge is near.)
int parts_seen(const Circle& circle, const std::vector<Pixel>& on) {
  std::array<bool, kDirections> seen{};
  for (const Pixel& step : on) {
    const double turn = std::atan2(step[1] - circle.centre[1], step[0] - circle.centre[0]) / (2.0 * std::numbers::pi) + 0.5;
    seen.at(std::min(static_cast<std::size_t>(turn * kDirections), seen.size() - 1)) = true;
  }
  return static_cast<int>(std::ranges::count(seen, true));
}

/// RANSAC (Fischler & Bolles 1981) with a fixed seed: the circle of which the longest piece of rim is seen.
std::optional<Circle> vote(const std::vector<Steps>& all, const View& view) {
  std::vector<Pixel> steps;
  for (const Steps& each : all) steps.insert(steps.end(), each.begin(), each.end());
  constexpr std::size_t kFewest = 12;
  if (steps.size() < kFewest) return std::nullopt;
  constexpr int kTrials = 2000;
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> index(0, steps.size() - 1);
  std::optional<Circle> best;
  double longest = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::optional<Circle> circle = circle_through(steps[index(random)], steps[index(random)], steps[index(random)]);
    if (!circle || !plausible(*circle, view)) continue;
    const double length = circle->radius * parts_seen(*circle, steps_on(*circle, all));
    if (length <= longest) continue;
    longest = length;
    best = circle;
  }
  return best;
}

/// Least squares of the distances, by Gauss and Newton.
Circle refined(Circle circle, const std::vector<Steps>& all) {
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (const Pixel& step : steps_on(circle, all)) {
      const double away = std::hypot(step[0] - circle.centre[0], step[1] - circle.centre[1]);
      const Eigen::Vector3d J(-(step[0] - circle.centre[0]) / away, -(step[1] - circle.centre[1]) / away, -1.0);
      normal_matrix += J * J.transpose();
      gradient += J * (away - circle.radius);
    }
    const Eigen::Vector3d change = normal_matrix.ldlt().solve(-gradient);
    if (!change.allFinite()) break;
    circle.centre[0] += change[0];
    circle.centre[1] += change[1];
    circle.radius += change[2];
  }
  return circle;
}

/// How much of what lies beyond the circle is dark; nothing if next to nothing lies there.
std::optional<double> dark_share_beyond(const Circle& circle, const View& view, const Levels& levels) {
  constexpr double kBlur = 3.0;  // px
  constexpr double kNextToNothing = 5e-4;
  const GreyImage& image = view.image();
  double beyond = 0.0;
  double dark = 0.0;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      if (circle.distance({static_cast<double>(column), static_cast<double>(row)}) <= kBlur) continue;
      beyond += 1.0;
      if (view.at(column, row) <= levels.threshold) dark += 1.0;
    }
  }
  if (beyond < kNextToNothing * static_cast<double>(image.samples.size())) return std::nullopt;
  return dark / beyond;
}

/// The share of the rim inside the image that the steps confirm, and how far these are from it.
LensCircle confirmed(const Circle& circle, const std::vector<Steps>& all, const View& view) {
  LensCircle result{circle.centre, circle.radius, 0.0, 0.0, ""};
  const std::vector<Pixel> on = steps_on(circle, all);
  for (const Pixel& step : on) result.rms_px += circle.distance(step) * circle.distance(step) / static_cast<double>(on.size());
  result.rms_px = std::sqrt(result.rms_px);
  int visible = 0;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kDirections;
    visible +=
        view.inside({circle.centre[0] + circle.radius * std::cos(angle), circle.centre[1] + circle.radius * std::sin(angle)});
  }
  if (visible > 0) result.rim_share = std::min(1.0, static_cast<double>(parts_seen(circle, on)) / visible);
  return result;
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

std::optional<LensCircle> find_lit_circle(const GreyImage& image) {
  constexpr int kSmallest = 16;  // px
  if (image.width < kSmallest || image.height < kSmallest) return std::nullopt;
  const View view(image);
  const std::optional<Levels> levels = levels_of(view);
  if (!levels) return std::nullopt;
  const Pixel middle = {(image.width - 1) / 2.0, (image.height - 1) / 2.0};
  std::vector<Steps> steps = steps_from_dark(view, *levels, middle);
  std::optional<Circle> circle = vote(steps, view);
  if (!circle) return std::nullopt;
  // Seen from its own centre each direction meets the rim at right angles.
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) {
    circle = refined(*circle, steps);
    if (!plausible(*circle, view)) return std::nullopt;
    steps = steps_from_dark(view, *levels, circle->centre);
  }
  circle = refined(*circle, steps);
  if (!plausible(*circle, view)) return std::nullopt;
  const LensCircle result = confirmed(*circle, steps, view);
  constexpr double kLeastOfRim = 0.12;
  constexpr double kMostlyDark = 0.7;  // the rest is flare
  const std::optional<double> dark = dark_share_beyond(*circle, view, *levels);
  if (result.rim_share < kLeastOfRim || !dark || *dark < kMostlyDark) return std::nullopt;
  return result;
}

}  // namespace fca
