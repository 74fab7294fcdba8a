// SPDX-License-Identifier: BSD-3-Clause
#include "variable_projection.h"

#include "normal_equations.h"

#include <algorithm>
#include <limits>

namespace fca::internal {

bool VariableProjection::AxisEquations::compute(SampleJacobian& jacobian, std::size_t axis) {
  const std::size_t points = jacobian.rows() / 2;
  const std::span<const Column> all = jacobian.columns();
  std::array<Column, kMostShapeParameters + kOtherColumns> columns;
  std::size_t count = 0;
  const auto add = [&](const Column& column) { columns[count++] = {column.data, axis * points, (axis + 1) * points}; };
  std::ranges::for_each(all.subspan(kLinear), add);
  shape_count_ = count;
  add(all[axis]);
  add(all[axis + 2]);
  add(jacobian.residuals());
  dot_products(std::span(columns).first(count), dots_.data());
  return solve();
}

/// Solves the 2 x 2 normal equations for the changes f, c of focal length and centre that minimise
/// |residual + f focal + c centre|^2, where each word is a column.
bool VariableProjection::AxisEquations::solve() {
  const double largest = dot(focal(), focal()) * dot(centre(), centre());
  const double determinant = largest - dot(focal(), centre()) * dot(focal(), centre());
  if (!(determinant > std::numeric_limits<double>::epsilon() * largest)) return false;
  inverse_ = {dot(centre(), centre()) / determinant, -dot(focal(), centre()) / determinant,
              dot(focal(), focal()) / determinant};
  const auto [of_focal, of_centre] = solution(dot(focal(), residual()), dot(centre(), residual()));
  change_ = {-of_focal, -of_centre};
  return true;
}

std::array<double, 2> VariableProjection::AxisEquations::solution(double right_of_focal, double right_of_centre) const {
  return {inverse_[0] * right_of_focal + inverse_[1] * right_of_centre,
          inverse_[1] * right_of_focal + inverse_[2] * right_of_centre};
}

double VariableProjection::AxisEquations::cost() const {
  const double gain = change_[0] * dot(focal(), residual()) + change_[1] * dot(centre(), residual());
  return std::max(0.0, dot(residual(), residual()) + gain);
}

/// Removes from each shape column the part that focal length and centre can compensate (Kaufman's approximation). Multiplies
/// the columns by `scale`, since they are proportional to the focal length.
void VariableProjection::AxisEquations::add_to(double scale, const NormalEquations& sums) const {
  for (std::size_t i = 0; i < shape_count_; ++i) {
    sums.gradient[i] += scale * (dot(i, residual()) + change_[0] * dot(i, focal()) + change_[1] * dot(i, centre()));
    const auto [of_focal, of_centre] = solution(dot(i, focal()), dot(i, centre()));
    for (std::size_t j = i; j < shape_count_; ++j) {
      sums.hessian[i * shape_count_ + j] +=
          scale * scale * (dot(i, j) - of_focal * dot(j, focal()) - of_centre * dot(j, centre()));
    }
  }
}

bool VariableProjection::can_fit(const FitTarget& target, const std::array<bool, kMostParameters>& fixed) {
  // With more shape parameters the search over the shape itself follows a narrow valley: it was no faster for mei and rational
  // (5 and 8 shape parameters).
  constexpr std::size_t kMostFreeShapeParameters = 2;
  if (!target.focal_lengths_first() || !target.cheap_derivatives()) return false;
  const auto count_free = [](std::span<const bool> held) { return static_cast<std::size_t>(std::ranges::count(held, false)); };
  const std::span<const bool> held = std::span(fixed).first(target.parameters().size());
  const std::size_t shape = count_free(held.subspan(kLinear));
  return count_free(held.first(kLinear)) == kLinear && shape > 0 && shape <= kMostFreeShapeParameters;
}

VariableProjection::VariableProjection(SampleJacobian& jacobian, const ParameterValues& start,
                                       const std::array<bool, kMostParameters>& fixed)
    : jacobian_(jacobian), values_(start) {
  const std::size_t count = jacobian.columns().size() - kLinear;
  for (std::size_t i = kLinear; count_ < count; ++i) {
    if (fixed[i]) continue;
    indices_[count_] = i;
    start_[count_++] = start[i];
  }
}

/// Computes axes_ at `values`, unless the last call did: the solver needs the derivatives at the point at which it has just
/// evaluated the cost. False if a sample has no pixel, or the samples do not determine focal length and centre.
bool VariableProjection::compute_equations(const ParameterValues& values) {
  if (at_ == values) return true;
  at_.reset();
  if (!jacobian_.compute_jacobian(values)) return false;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!axes_[axis].compute(jacobian_, axis)) return false;
  }
  at_ = values;
  return true;
}

bool VariableProjection::evaluate(const double* shape, NormalEquations& sums) {
  ParameterValues values = values_;
  for (std::size_t i = 0; i < count_; ++i) values[indices_[i]] = shape[i];
  if (!compute_equations(values)) return false;
  sums.cost = 0.0;
  std::ranges::fill(sums.gradient, 0.0);
  std::ranges::fill(sums.hessian, 0.0);
  const bool with_derivatives = !sums.gradient.empty();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const AxisEquations& equations = axes_[axis];
    double& focal = values[axis];
    const double scale = 1.0 + equations.focal_change() / focal;
    if (!(scale > 0.0)) return false;
    sums.cost += equations.cost();
    if (!with_derivatives) continue;
    equations.add_to(scale, sums);
    focal *= scale;
    values[axis + 2] += equations.centre_change();
  }
  if (with_derivatives) values_ = values;
  return true;
}

ParameterValues VariableProjection::values_at(std::span<const double> shape) {
  std::array<double, kMostShapeParameters> gradient{};
  std::array<double, kMostShapeParameters * kMostShapeParameters> hessian{};
  NormalEquations sums{0.0, std::span(gradient).first(count_), std::span(hessian).first(count_ * count_)};
  evaluate(shape.data(), sums);
  return values_;
}

}  // namespace fca::internal
