// SPDX-License-Identifier: BSD-3-Clause
// The QR decomposition J = Q R of a Jacobian, and the coordinates y = R (x - x0), in which its columns are orthonormal.
#pragma once

#include "normal_equations.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fca::internal {

class QrDecomposition {
 public:
  /// Starts the decomposition of a Jacobian of that size.
  void reset(std::size_t rows, std::size_t columns);
  /// Adds the next column of J (all rows).
  void add(const double* column);
  /// values += R^-1 y.
  void step(const double* y, double* values) const;
  /// Writes J R^-1 of another J into `space`. Reads all rows of every column.
  void transform(std::span<const Column> jacobian, std::vector<double>& space);
  /// The columns of a matrix that transform() wrote. Valid until the next call.
  [[nodiscard]] std::span<const Column> columns(const std::vector<double>& space);

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t added_ = 0;
  std::vector<double> q_;        ///< rows x columns, column by column
  std::vector<double> inverse_;  ///< R^-1, row-major; 0 for a column that the ones before it span
  std::vector<Column> views_;
};

}  // namespace fca::internal
