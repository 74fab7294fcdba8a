// SPDX-License-Identifier: BSD-3-Clause
// The QR decomposition J = Q R of a Jacobian J with respect to parameters x, and the coordinates y = R (x - x0). The columns of
// the Jacobian with respect to y are orthonormal.
#pragma once

#include "normal_equations.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fca::internal {

class QrDecomposition {
 public:
  /// Begins the decomposition of a Jacobian of the given size. One call of add() per column must follow.
  void reset(std::size_t rows, std::size_t columns);
  /// Adds the next column of J, which has a number for every row.
  void add(const double* column);
  /// Adds R^-1 y, the step of the parameters that belongs to y, to `values`.
  void step(const double* y, double* values) const;
  /// Writes J R^-1, the derivatives with respect to y, for another Jacobian J of the same size. Reads all rows of every column.
  void transform(std::span<const Column> jacobian, std::vector<double>& result);
  /// The columns of a matrix that transform() wrote. The result is valid until the next call.
  [[nodiscard]] std::span<const Column> columns(const std::vector<double>& transformed);

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t added_ = 0;        ///< The number of columns so far.
  std::vector<double> q_;        ///< rows x columns, column by column
  std::vector<double> inverse_;  ///< R^-1, row-major; a column of zeros if the columns of J before it span that column of J
  std::vector<Column> views_;
};

}  // namespace fca::internal
