// SPDX-License-Identifier: BSD-3-Clause
// Minimises a convex quadratic under linear inequalities.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace fca::internal {

/// The x that minimises x'H x / 2 + g'x with every element of A x - b at least 0. H: n x n, positive definite; A: m x n; m may
/// be 0. nullopt if H is not positive definite, or no x satisfies all inequalities.
///
/// The problem is solved as a least-distance problem, by non-negative least squares (Lawson and Hanson, Solving Least Squares
/// Problems, 1974, chapter 23).
[[nodiscard]] std::optional<Eigen::VectorXd> minimise_quadratic(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                                                const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace fca::internal
