// SPDX-License-Identifier: BSD-3-Clause
#include "qr_decomposition.h"

#include <algorithm>
#include <cmath>

namespace fca::internal {

void QrDecomposition::reset(std::size_t rows, std::size_t columns) {
  rows_ = rows;
  columns_ = columns;
  added_ = 0;
  q_.assign(rows * columns, 0.0);
  inverse_.assign(columns * columns, 0.0);
}

// Gram-Schmidt orthogonalisation in two passes is as accurate as Householder's method. The new column of Q is q = (a - sum over
// i of c_i q_i) / n, where a is the column of J. The new column j of R^-1 is therefore (e_j - sum over i of c_i r_i) / n, where
// r_i are its earlier columns and e_j is a unit vector.
void QrDecomposition::add(const double* column) {
  const std::size_t j = added_++;
  double* const q = q_.data() + j * rows_;
  std::copy_n(column, rows_, q);
  const auto dot = [this](const double* a, const double* b) {
    const Column x{a, 0, rows_};
    double result = 0.0;
    dot_products(std::span(&x, 1), Column{b, 0, rows_}, &result);
    return result;
  };
  const double length = std::sqrt(dot(q, q));
  inverse_[j * columns_ + j] = 1.0;
  constexpr int kPasses = 2;
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t i = 0; i < j; ++i) {
      const double* const other = q_.data() + i * rows_;
      const double share = dot(other, q);
      for (std::size_t k = 0; k < rows_; ++k) q[k] -= share * other[k];
      for (std::size_t row = 0; row <= i; ++row) inverse_[row * columns_ + j] -= share * inverse_[row * columns_ + i];
    }
  }
  const double rest = std::sqrt(dot(q, q));
  constexpr double kRounding = 1e-14;  // with a smaller rest the earlier columns span this one
  const double scale = rest > kRounding * length ? 1.0 / rest : 0.0;
  for (std::size_t k = 0; k < rows_; ++k) q[k] *= scale;
  for (std::size_t row = 0; row <= j; ++row) inverse_[row * columns_ + j] *= scale;
}

void QrDecomposition::step(const double* y, double* values) const {
  for (std::size_t row = 0; row < columns_; ++row) {
    for (std::size_t j = row; j < columns_; ++j) values[row] += inverse_[row * columns_ + j] * y[j];
  }
}

void QrDecomposition::transform(std::span<const Column> jacobian, std::vector<double>& result) {
  result.assign(rows_ * columns_, 0.0);
  for (std::size_t j = 0; j < columns_; ++j) {
    double* const to = result.data() + j * rows_;
    for (std::size_t i = 0; i <= j; ++i) {
      const double factor = inverse_[i * columns_ + j];
      const double* const from = jacobian[i].data;
      for (std::size_t k = 0; k < rows_; ++k) to[k] += factor * from[k];
    }
  }
}

std::span<const Column> QrDecomposition::columns(const std::vector<double>& transformed) {
  views_.resize(columns_);
  for (std::size_t j = 0; j < columns_; ++j) views_[j] = {transformed.data() + j * rows_, 0, rows_};
  return views_;
}

}  // namespace fca::internal
