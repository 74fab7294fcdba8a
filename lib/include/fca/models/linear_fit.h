// SPDX-License-Identifier: BSD-3-Clause
// Small linear least squares for the starts of fits, without Eigen in a public header.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace fca::internal {

/// Solves A x = b, A symmetric n x n row-major, b in `x` on entry. Singular directions get some solution; zeros if none is
/// finite.
void solve_symmetric(std::span<const double> matrix, std::span<double> x);

/// Weighted least squares in N unknowns by its normal equations: rows are added one by one, nothing is stored.
template <std::size_t N>
class LinearFit {
 public:
  /// One equation row . x = target.
  void add(const std::array<double, N>& row, double target, double weight) {
    for (std::size_t i = 0; i < N; ++i) {
      const double weighted = weight * row[i];
      for (std::size_t j = i; j < N; ++j) normal_[N * i + j] += weighted * row[j];
      right_[i] += weighted * target;
    }
  }

  /// Writes the N unknowns.
  void solve(double* x) const {
    std::array<double, N* N> normal = normal_;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < i; ++j) normal[N * i + j] = normal[N * j + i];
    }
    std::array<double, N> solution = right_;
    solve_symmetric(normal, solution);
    for (std::size_t i = 0; i < N; ++i) x[i] = solution[i];
  }

 private:
  std::array<double, N * N> normal_{};  ///< The upper triangle.
  std::array<double, N> right_{};
};

}  // namespace fca::internal
