// SPDX-License-Identifier: BSD-3-Clause
#include "projected.h"

#include "normal_equations.h"

#include <algorithm>
#include <limits>

namespace fca::internal {

bool Projected::Coordinate::look_at(SampleJacobian& jacobian, std::size_t axis) {
  const std::size_t points = jacobian.rows() / 2;
  const std::span<const Column> all = jacobian.columns();
  std::array<Column, kMostShape + kOthers> columns;
  std::size_t count = 0;
  const auto add = [&](const Column& column) { columns[count++] = {column.data, axis * points, (axis + 1) * points}; };
  std::ranges::for_each(all.subspan(kLinear), add);
  shape_ = count;
  add(all[axis]);
  add(all[axis + 2]);
  add(jacobian.residuals());
  dot_products(std::span(columns).first(count), sums_.data());
  return solve();
}

/// Solves the 2 x 2 normal equations for the changes f, c of focal length and centre that minimise the sum of (residual + f
/// focal + c centre)^2.
bool Projected::Coordinate::solve() {
  const double largest = sum(focal(), focal()) * sum(centre(), centre());
  const double determinant = largest - sum(focal(), centre()) * sum(focal(), centre());
  if (!(determinant > std::numeric_limits<double>::epsilon() * largest)) return false;
  inverse_ = {sum(centre(), centre()) / determinant, -sum(focal(), centre()) / determinant,
              sum(focal(), focal()) / determinant};
  const auto [of_focal, of_centre] = solution(sum(focal(), residual()), sum(centre(), residual()));
  change_ = {-of_focal, -of_centre};
  return true;
}

std::array<double, 2> Projected::Coordinate::solution(double of_focal, double of_centre) const {
  return {inverse_[0] * of_focal + inverse_[1] * of_centre, inverse_[1] * of_focal + inverse_[2] * of_centre};
}

/// The sum of squares after solve()'s changes, computed from the dot products alone.
double Projected::Coordinate::cost() const {
  const double gain = change_[0] * sum(focal(), residual()) + change_[1] * sum(centre(), residual());
  return std::max(0.0, sum(residual(), residual()) + gain);
}

/// Adds gradient and Gauss-Newton matrix of the cost as a function of the shape alone. Of each shape column only the part that
/// focal length and centre cannot compensate counts (Kaufman's approximation). The columns are proportional to the focal
/// length, which solve() multiplies by `scale`.
void Projected::Coordinate::add_to(double scale, const NormalEquations& sums) const {
  for (std::size_t i = 0; i < shape_; ++i) {
    sums.gradient[i] += scale * (sum(i, residual()) + change_[0] * sum(i, focal()) + change_[1] * sum(i, centre()));
    const auto [of_focal, of_centre] = solution(sum(i, focal()), sum(i, centre()));
    for (std::size_t j = i; j < shape_; ++j)
      sums.hessian[i * shape_ + j] += scale * scale * (sum(i, j) - of_focal * sum(j, focal()) - of_centre * sum(j, centre()));
  }
}

bool Projected::suits(const FitTarget& target, const std::array<bool, kMostParameters>& fixed) {
  // With more shape parameters the search for these is itself a narrow valley: mei and rational (5 and 8 parameters) became no
  // faster.
  constexpr std::size_t kFew = 2;
  if (!target.focal_lengths_first() || !target.cheap_derivatives()) return false;
  const auto count_free = [](std::span<const bool> held) { return static_cast<std::size_t>(std::ranges::count(held, false)); };
  const std::span<const bool> held = std::span(fixed).first(target.parameters().size());
  const std::size_t shape = count_free(held.subspan(kLinear));
  return count_free(held.first(kLinear)) == kLinear && shape > 0 && shape <= kFew;
}

Projected::Projected(SampleJacobian& jacobian, const ParameterValues& start, const std::array<bool, kMostParameters>& fixed)
    : jacobian_(jacobian), values_(start) {
  const std::size_t count = jacobian.columns().size() - kLinear;
  for (std::size_t i = kLinear; count_ < count; ++i) {
    if (fixed[i]) continue;
    indices_[count_] = i;
    start_[count_++] = start[i];
  }
}

/// Computes the sums at `values`, unless the last call did: the solver needs the derivatives where it has just needed the cost.
/// False if a sample has no pixel, or the samples do not determine focal length and centre.
bool Projected::look_at(const ParameterValues& values) {
  if (at_ == values) return true;
  at_.reset();
  if (!jacobian_.compute_jacobian(values)) return false;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!coordinates_[axis].look_at(jacobian_, axis)) return false;
  }
  at_ = values;
  return true;
}

bool Projected::evaluate(const double* shape, NormalEquations& sums) {
  ParameterValues values = values_;
  for (std::size_t i = 0; i < count_; ++i) values[indices_[i]] = shape[i];
  if (!look_at(values)) return false;
  sums.cost = 0.0;
  std::ranges::fill(sums.gradient, 0.0);
  std::ranges::fill(sums.hessian, 0.0);
  const bool with_derivatives = !sums.gradient.empty();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Coordinate& coordinate = coordinates_[axis];
    double& focal = values[axis];
    const double scale = 1.0 + coordinate.focal_change() / focal;
    if (!(scale > 0.0)) return false;
    sums.cost += coordinate.cost();
    if (!with_derivatives) continue;
    coordinate.add_to(scale, sums);
    focal *= scale;
    values[axis + 2] += coordinate.centre_change();
  }
  if (with_derivatives) values_ = values;
  return true;
}

ParameterValues Projected::values_at(std::span<const double> shape) {
  std::array<double, kMostShape> gradient{};
  std::array<double, kMostShape * kMostShape> hessian{};
  NormalEquations sums{0.0, std::span(gradient).first(count_), std::span(hessian).first(count_ * count_)};
  evaluate(shape.data(), sums);
  return values_;
}

}  // namespace fca::internal
