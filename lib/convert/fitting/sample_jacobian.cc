// SPDX-License-Identifier: BSD-3-Clause
#include "sample_jacobian.h"

#include <algorithm>
#include <cmath>

namespace fca::internal {

void SampleJacobian::reset(std::vector<Correspondence> samples, const std::array<bool, kMostParameters>& fixed) {
  samples_ = std::move(samples);
  const std::size_t points = samples_.size();
  const std::size_t count = target_.parameters().size();
  roots_.resize(points);
  std::ranges::transform(samples_, roots_.begin(), [](const Correspondence& s) { return std::sqrt(s.weight); });
  numbers_.resize((count + 1) * rows());
  columns_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (fixed[i]) continue;
    Column column{out().column(i), 0, rows()};
    // fx and cx affect only u, fy and cy only v.
    if (target_.focal_lengths_first() && i < 4) (i % 2 == 0 ? column.end : column.begin) = points;
    columns_.push_back(column);
  }
  at_.reset();
}

bool SampleJacobian::evaluate(const ParameterValues& values, NormalEquations& sums) {
  const bool with_derivatives = !sums.gradient.empty();
  // The solver mostly needs the derivatives at the point at which it has just evaluated the cost. If derivatives are cheap,
  // they are therefore computed together with the cost and kept.
  if (!(with_derivatives || target_.cheap_derivatives() ? compute_jacobian(values) : compute_residuals(values))) return false;
  const Column r = residuals();
  dot_products(std::span(&r, 1), r, &sums.cost);
  if (with_derivatives) {
    dot_products(columns_, r, sums.gradient.data());
    dot_products(columns_, sums.hessian.data());
  }
  return true;
}

bool SampleJacobian::compute_jacobian(const ParameterValues& values) {
  if (at_ == values) return true;
  at_.reset();
  if (!target_.compute_jacobian(values.data(), samples_, out())) return false;
  at_ = values;
  return true;
}

/// Computes only the residuals; columns() are then invalid. False if a sample has no pixel.
bool SampleJacobian::compute_residuals(const ParameterValues& values) {
  at_.reset();
  const std::size_t points = samples_.size();
  pixels_.resize(points);
  if (!target_.pixels(values.data(), samples_, pixels_.data())) return false;
  double* const r = out().column(target_.parameters().size());
  for (std::size_t k = 0; k < points; ++k) {
    r[k] = roots_[k] * (pixels_[k][0] - samples_[k].pixel[0]);
    r[points + k] = roots_[k] * (pixels_[k][1] - samples_[k].pixel[1]);
  }
  return true;
}

}  // namespace fca::internal
