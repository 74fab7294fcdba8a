// SPDX-License-Identifier: BSD-3-Clause
// Coordinates in which the columns of a Jacobian J are orthonormal: J = Q R, and y = R (x - x0).
#pragma once

#include "products.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fca::internal {

class Orthonormal {
 public:
  /// Begins anew, for a Jacobian of that size.
  void reset(std::size_t rows, std::size_t columns);
  /// The next column of J.
  void add(const double* column);
  /// values += R^-1 y.
  void step(const double* y, double* values) const;
  /// J R^-1 of another J (all rows of every column are read), into `space`.
  void transform(std::span<const Column> jacobian, std::vector<double>& space);
  /// Its columns.
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
