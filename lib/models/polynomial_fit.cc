// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/polynomial_fit.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/QR>

namespace fca {

std::vector<double> fit_powers(std::span<const double> x, std::span<const double> y, std::size_t count) {
  if (x.size() < count || x.size() != y.size() || count == 0) return {};
  double largest = 0.0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  if (!(largest > 0.0)) return {};
  const auto rows = static_cast<Eigen::Index>(x.size());
  const auto columns = static_cast<Eigen::Index>(count);
  // In units of the largest |x|, so that the size of a coefficient is that of its largest term.
  Eigen::MatrixXd powers(rows, columns);
  for (Eigen::Index j = 0; j < rows; ++j) {
    double power = 1.0;
    for (Eigen::Index i = 0; i < columns; ++i) {
      powers(j, i) = power;
      power *= x[static_cast<std::size_t>(j)] / largest;
    }
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  constexpr double kRounding = 1e-15;
  decomposition.setThreshold(kRounding);
  decomposition.compute(powers);
  const Eigen::Map<const Eigen::VectorXd> target(y.data(), rows);
  Eigen::VectorXd solution = decomposition.solve(target);
  // The residual is small against the terms that cancel to it: once more, with more digits.
  Eigen::VectorXd residual(rows);
  for (Eigen::Index j = 0; j < rows; ++j) {
    long double value = 0.0L;
    for (Eigen::Index i = columns; i-- > 0;) {
      value =
          value * static_cast<long double>(x[static_cast<std::size_t>(j)] / largest) + static_cast<long double>(solution[i]);
    }
    residual[j] = static_cast<double>(static_cast<long double>(target[j]) - value);
  }
  solution += decomposition.solve(residual);
  std::vector<double> coefficients(count);
  double unit = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    coefficients[i] = solution[static_cast<Eigen::Index>(i)] / unit;
    unit *= largest;
  }
  return coefficients;
}

}  // namespace fca
