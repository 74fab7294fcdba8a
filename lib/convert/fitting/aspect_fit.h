// SPDX-License-Identifier: BSD-3-Clause
// Fits of models that are linear once fy / fx is given (pinhole, kb4, radtan, woodscape):
//   u = c . t_u(ray) + cx,  v = aspect c . t_v(ray) + cy
// One pass of moment sums, one linear solve, and two or three Gauss-Newton steps for the aspect ratio: no start, no search.
#pragma once

#include <fca/convert/fit_target.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// Holds terms and pixels of all points, each times the square root of the point's weight.
class AspectFit {
 public:
  AspectFit(std::size_t terms, std::size_t points) : terms_(terms), points_(points), numbers_((2 * terms + 3) * points) {}

  /// Sets one point. `pixel`: px, relative to a point near the principal point, which keeps rounding errors small.
  void set(std::size_t point, const double* terms_u, const double* terms_v, const std::array<double, 2>& pixel, double weight);

  struct Solution {
    std::array<double, kMostTerms> coefficients{};
    double aspect = 1.0;
    std::array<double, 2> point{};  ///< cx, cy [px], relative to the same point as the pixels.
    double cost = 0.0;              ///< Sum of weighted squared residuals [px^2].
    int iterations = 0;
  };
  /// `aspect`: fy / fx to begin with. nullopt if the points do not determine the unknowns, or the iteration diverges.
  [[nodiscard]] std::optional<Solution> solve(double aspect);

 private:
  double* term_u(std::size_t term) { return numbers_.data() + term * points_; }
  double* term_v(std::size_t term) { return numbers_.data() + (terms_ + term) * points_; }
  double* roots() { return numbers_.data() + 2 * terms_ * points_; }
  double* pixels(std::size_t axis) { return numbers_.data() + (2 * terms_ + 1 + axis) * points_; }

  std::size_t terms_;
  std::size_t points_;
  std::vector<double> numbers_;
};

}  // namespace fca::internal
