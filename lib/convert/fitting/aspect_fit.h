// SPDX-License-Identifier: BSD-3-Clause
// Fits models that are linear in all other parameters once aspect = fy / fx is given (pinhole, kb4, radtan, woodscape):
//   u = c . t_u(ray) + cx,  v = aspect c . t_v(ray) + cy
// c: the coefficients; t_u, t_v: the model's terms, which depend only on the ray. A linear solution with a guess of the aspect
// ratio is followed by two or three Gauss-Newton steps for all unknowns. The fit needs no start and no search.
#pragma once

#include <fca/convert/fit_target.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// A fit to weighted points. The class stores terms and pixels of all points, each times the square root of the point's weight.
class AspectFit {
 public:
  AspectFit(std::size_t terms, std::size_t points) : terms_(terms), points_(points), numbers_((2 * terms + 3) * points) {}

  /// Sets the point with index `point`. `pixel` [px] is relative to any origin near the principal point, which keeps rounding
  /// errors small.
  void set(std::size_t point, const double* terms_u, const double* terms_v, const std::array<double, 2>& pixel, double weight);

  struct Solution {
    std::array<double, kMostTerms> coefficients{};
    double aspect = 1.0;
    std::array<double, 2> point{};  ///< cx, cy [px], relative to the origin of the pixels.
    double cost = 0.0;              ///< Sum of weighted squared residuals [px^2].
    int iterations = 0;
  };
  /// Fits all points. `aspect`: a guess of fy / fx. nullopt if the points do not determine the unknowns, or the iteration does
  /// not converge.
  [[nodiscard]] std::optional<Solution> solve(double aspect);

 private:
  double* term_u(std::size_t term) { return numbers_.data() + term * points_; }
  double* term_v(std::size_t term) { return numbers_.data() + (terms_ + term) * points_; }
  double* roots() { return numbers_.data() + 2 * terms_ * points_; }
  double* pixels(std::size_t axis) { return numbers_.data() + (2 * terms_ + 1 + axis) * points_; }

  std::size_t terms_;
  std::size_t points_;
  std::vector<double> numbers_;  ///< Columns with a number per point: terms of u, terms of v, roots of weights, u, v.
};

}  // namespace fca::internal
