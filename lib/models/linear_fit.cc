// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/linear_fit.h>

#include <cmath>

#include <Eigen/Core>
#include <Eigen/LU>

namespace fca::internal {

void solve_symmetric(std::span<const double> matrix, std::span<double> x) {
  // No fit of a camera has more unknowns; a fixed bound keeps Eigen off the heap.
  constexpr int kMostUnknowns = 16;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostUnknowns, kMostUnknowns>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostUnknowns, 1>;
  const auto n = static_cast<Eigen::Index>(x.size());
  const Matrix A =
      Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(matrix.data(), n, n);
  const Vector b = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
  // Unknowns in units of their own weight in the equations: powers of a radius differ by many orders of magnitude, and what is
  // small must not look singular.
  const Vector unit = A.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 1.0; });
  const Matrix scaled = unit.asDiagonal() * A * unit.asDiagonal();
  const Vector solution = unit.cwiseProduct(Vector(scaled.fullPivLu().solve(Vector(unit.cwiseProduct(b)))));
  Eigen::Map<Eigen::VectorXd> result(x.data(), n);
  result.setZero();
  if (solution.allFinite()) result = solution;
}

}  // namespace fca::internal
