// SPDX-License-Identifier: BSD-3-Clause
// The circle on which steps from dark to light lie, among others that do not.
#pragma once

#include "rim_steps.h"

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace fca::internal {

struct Circle {
  Pixel centre{};
  double radius = 0.0;

  [[nodiscard]] double distance(const Pixel& pixel) const {
    return std::hypot(pixel[0] - centre[0], pixel[1] - centre[1]) - radius;
  }
};

using IsPlausible = std::function<bool(const Circle&)>;

/// The step of each direction that lies nearest to the circle, where one lies on it.
[[nodiscard]] std::vector<Pixel> steps_on(const Circle& circle, const std::vector<Steps>& all);

/// In how many of as many equal parts of the rim there is a step. (Of steps alone there are many where an edge is near.)
[[nodiscard]] int parts_seen(const Circle& circle, const std::vector<Pixel>& on);

/// RANSAC (Fischler & Bolles 1981) with a fixed seed: the plausible circle of which the longest piece of rim is seen.
[[nodiscard]] std::optional<Circle> vote(const std::vector<Steps>& all, const IsPlausible& is_plausible);

/// Least squares of the distances, by Gauss and Newton.
[[nodiscard]] Circle refined(Circle circle, const std::vector<Steps>& all);

}  // namespace fca::internal
