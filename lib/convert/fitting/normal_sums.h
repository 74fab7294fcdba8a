// SPDX-License-Identifier: BSD-3-Clause
// The normal equations of a fit to several cameras: sums over the residuals of all cameras.
#pragma once

#include "minimise.h"

#include <Eigen/Core>

#include <algorithm>

namespace fca::internal {

class NormalSums {
 public:
  /// `count`: the number of unknowns. All sums begin at 0.
  explicit NormalSums(Eigen::Index count)
      : hessian_(Eigen::MatrixXd::Zero(count, count)), gradient_(Eigen::VectorXd::Zero(count)) {}

  /// Adds the residuals of one camera. Column i of their Jacobian `columns` belongs to the unknown first + i.
  void add(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residuals, Eigen::Index first = 0) {
    hessian_.block(first, first, columns.cols(), columns.cols()) += columns.transpose() * columns;
    gradient_.segment(first, columns.cols()) += columns.transpose() * residuals;
    cost_ += residuals.squaredNorm();
  }

  /// Copies the cost to `sums` (for minimise()), and gradient and Hessian unless their spans are empty.
  void put_into(NormalEquations& sums) const {
    sums.cost = cost_;
    if (sums.gradient.empty()) return;
    std::ranges::copy(gradient_, sums.gradient.begin());
    std::ranges::copy(hessian_.reshaped(), sums.hessian.begin());  // symmetric
  }

 private:
  Eigen::MatrixXd hessian_;
  Eigen::VectorXd gradient_;
  double cost_ = 0.0;
};

}  // namespace fca::internal
