// SPDX-License-Identifier: BSD-3-Clause
// The residuals of a model over samples, and their Jacobian with respect to the parameters that a fit may change, column by
// column.
#pragma once

#include "minimise.h"
#include "normal_equations.h"

#include <fca/convert/fit_target.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

class SampleJacobian {
 public:
  explicit SampleJacobian(const FitTarget& target) : target_(target) {}

  /// Replaces the samples. The Jacobian has a column for each parameter that is not fixed.
  void reset(std::vector<Correspondence> samples, const std::array<bool, kMostParameters>& fixed);

  /// The number of rows: those of u for all samples, then those of v.
  [[nodiscard]] std::size_t rows() const { return 2 * samples_.size(); }
  /// The Jacobian's columns and the residuals [px] at the parameters of the last compute_jacobian(), valid until the next call
  /// of evaluate(). Both are times the square roots of the samples' weights.
  [[nodiscard]] std::span<const Column> columns() const { return columns_; }
  [[nodiscard]] Column residuals() { return {out().column(target_.parameters().size()), 0, rows()}; }

  /// Computes the cost at `values`, and gradient and Hessian unless their spans are empty. False if a sample has no pixel.
  bool evaluate(const ParameterValues& values, NormalEquations& sums);
  /// Computes residuals() and columns() at `values`. False if a sample has no pixel.
  bool compute_jacobian(const ParameterValues& values);

 private:
  JacobianColumns out() { return {roots_, numbers_.data()}; }
  bool compute_residuals(const ParameterValues& values);

  const FitTarget& target_;
  std::vector<Correspondence> samples_;
  std::vector<double> roots_;    ///< Square roots of the samples' weights.
  std::vector<double> numbers_;  ///< The numbers of out().
  std::vector<std::array<double, 2>> pixels_;
  std::vector<Column> columns_;
  std::optional<ParameterValues> at_;  ///< The parameters for which the columns were computed; nullopt if they are invalid.
};

}  // namespace fca::internal
