// SPDX-License-Identifier: BSD-3-Clause
#include "quadratic_program.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace fca::internal {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Smaller numbers are rounding errors of dot products. Columns and right sides have the length 1.
constexpr double kRelativeRounding = 1e-12;

/// Returns the u that minimises |E u - f|, where only the elements of u with the indices `free` may differ from 0.
VectorXd least_squares(const MatrixXd& E, const VectorXd& f, const std::vector<Index>& free) {
  VectorXd u = VectorXd::Zero(E.cols());
  const VectorXd of_free = MatrixXd(E(Eigen::all, free)).colPivHouseholderQr().solve(f);
  for (std::size_t i = 0; i < free.size(); ++i) u[free[i]] = of_free[static_cast<Index>(i)];
  return u;
}

/// Returns the u without negative elements that minimises |E u - f| (algorithm NNLS of Lawson and Hanson, see the header).
VectorXd non_negative_least_squares(const MatrixXd& E, const VectorXd& f) {
  VectorXd u = VectorXd::Zero(E.cols());
  std::vector<Index> free;
  const Index most_rounds = 3 * E.cols();
  for (Index round = 0; round < most_rounds; ++round) {
    VectorXd gain = E.transpose() * (f - E * u);
    for (const Index i : free) gain[i] = 0.0;
    Index best = 0;
    if (E.cols() == 0 || !(gain.maxCoeff(&best) > kRelativeRounding)) return u;
    free.push_back(best);
    VectorXd next = least_squares(E, f, free);
    // If an element would become negative on the way from u to `next`, u moves only to the point at which the first such
    // element is 0. That element is then fixed at 0, and the problem is solved again.
    while (std::ranges::any_of(free, [&next](Index i) { return !(next[i] > 0.0); })) {
      double share = 1.0;
      Index first = free.front();
      for (const Index i : free) {
        if (next[i] > 0.0 || u[i] / (u[i] - next[i]) > share) continue;
        share = u[i] / (u[i] - next[i]);
        first = i;
      }
      u += share * (next - u);
      u[first] = 0.0;
      std::erase(free, first);
      if (free.empty()) return VectorXd::Zero(E.cols());
      next = least_squares(E, f, free);
    }
    u = next;
  }
  return u;
}

}  // namespace

std::optional<VectorXd> minimise_quadratic(const MatrixXd& H, const VectorXd& g, const MatrixXd& A, const VectorXd& b) {
  if (!(H.diagonal().minCoeff() > 0.0)) return std::nullopt;
  const VectorXd unit = H.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LLT<MatrixXd> factors(unit.asDiagonal() * H * unit.asDiagonal());
  if (factors.info() != Eigen::Success) return std::nullopt;
  // With y = L' x / unit + L^-1 (unit g) the quadratic is |y|^2 / 2 plus a constant.
  const VectorXd shift = factors.matrixL().solve(unit.cwiseProduct(g));
  const auto x_of = [&](const VectorXd& y) {
    const VectorXd moved = y - shift;
    return VectorXd(unit.cwiseProduct(factors.matrixU().solve(moved)));
  };
  const Index n = H.rows();
  // In y the inequalities are G y >= h. E consists of the columns [G'; h'].
  MatrixXd E(n + 1, A.rows());
  E.topRows(n) = factors.matrixL().solve(MatrixXd(unit.asDiagonal() * A.transpose()));
  E.row(n) = (b + E.topRows(n).transpose() * shift).transpose();
  for (Index i = 0; i < E.cols(); ++i) E.col(i).normalize();
  const VectorXd f = VectorXd::Unit(n + 1, n);
  const VectorXd residual = E * non_negative_least_squares(E, f) - f;
  if (!(residual[n] < -kRelativeRounding)) return std::nullopt;
  VectorXd x = x_of(-residual.head(n) / residual[n]);
  if (!x.allFinite()) return std::nullopt;
  return x;
}

}  // namespace fca::internal
