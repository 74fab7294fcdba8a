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

/// Terms and pixels of all points, times the root of the point's weight.
class AspectFit {
 public:
  AspectFit(std::size_t terms, std::size_t points) : terms_(terms), points_(points), numbers_((2 * terms + 3) * points) {}

  /// `pixel` is best counted from about the principal point.
  void set(std::size_t point, const double* terms_u, const double* terms_v, const std::array<double, 2>& pixel, double weight);

  struct Solution {
    std::array<double, kMostTerms> coefficients{};
    double aspect = 1.0;
    std::array<double, 2> point{};  ///< cx, cy, from where the pixels are counted.
    double cost = 0.0;              ///< Sum of weighted squared residuals.
    int iterations = 0;
  };
  /// Nothing where the points do not determine the unknowns.
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
