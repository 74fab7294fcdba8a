// SPDX-License-Identifier: BSD-3-Clause
#include "circle_vote.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <numbers>
#include <random>

namespace fca::internal {

namespace {

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

double tolerance_of(const Circle& circle) { return std::max(1.5, 0.004 * circle.radius); }

}  // namespace

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

int parts_seen(const Circle& circle, const std::vector<Pixel>& on) {
  std::array<bool, kDirections> seen{};
  for (const Pixel& step : on) {
    const double turn = std::atan2(step[1] - circle.centre[1], step[0] - circle.centre[0]) / (2.0 * std::numbers::pi) + 0.5;
    seen.at(std::min(static_cast<std::size_t>(turn * kDirections), seen.size() - 1)) = true;
  }
  return static_cast<int>(std::ranges::count(seen, true));
}

std::optional<Circle> vote(const std::vector<Steps>& all, const IsPlausible& is_plausible) {
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
    if (!circle || !is_plausible(*circle)) continue;
    const std::vector<Pixel> on = steps_on(*circle, all);
    if (circle->radius * static_cast<double>(on.size()) <= longest) continue;  // no more parts are seen than steps
    const double length = circle->radius * parts_seen(*circle, on);
    if (length <= longest) continue;
    longest = length;
    best = circle;
  }
  return best;
}

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

}  // namespace fca::internal
