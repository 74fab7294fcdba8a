// SPDX-License-Identifier: BSD-3-Clause
#include "gauss_pixels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace fca::internal {

namespace {

/// Computes the nodes by the method of Golub & Welsch (1969): they are the eigenvalues of the Jacobi matrix of the measure's
/// orthogonal polynomials. For N pixels these are the discrete Chebyshev polynomials,
/// p_(k+1) = (x - (N - 1) / 2) p_k - b_k p_(k-1) with b_k = k^2 (N^2 - k^2) / (4 (4 k^2 - 1)).
std::vector<Node> compute_gauss_pixels(int n, int pixels) {
  const double middle = 0.5 * (pixels - 1.0);
  Eigen::VectorXd next_to_diagonal(n - 1);
  for (int k = 1; k < n; ++k) {
    const double square = static_cast<double>(k) * k;
    next_to_diagonal[k - 1] =
        std::sqrt(square * (static_cast<double>(pixels) * pixels - square) / (4.0 * (4.0 * square - 1.0)));
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::VectorXd::Zero(n), next_to_diagonal);
  std::vector<Node> nodes(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const double position = std::clamp(middle + solver.eigenvalues()[i], 0.0, 2.0 * middle);
    const double first = solver.eigenvectors()(0, i);
    nodes[static_cast<std::size_t>(i)] = {position, first * first};
  }
  return nodes;
}

}  // namespace

const std::vector<Node>& gauss_pixels(int n, int pixels) {
  thread_local std::map<std::pair<int, int>, std::vector<Node>> known;
  n = std::min(n, pixels);
  std::vector<Node>& nodes = known[{n, pixels}];
  if (nodes.empty()) nodes = compute_gauss_pixels(n, pixels);
  return nodes;
}

}  // namespace fca::internal
