// SPDX-License-Identifier: BSD-3-Clause
// Minimises a convex quadratic function under linear inequalities.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace fca::internal {

/// Returns the x that minimises x'H x / 2 + g'x under the condition that no element of A x - b is negative. H is an n x n
/// matrix and must be positive definite. A is m x n, where m may be 0. nullopt if H is not positive definite, or no x meets the
/// condition.
///
/// The function solves this as a least-distance problem by non-negative least squares (Lawson and Hanson, Solving Least Squares
/// Problems, 1974, chapter 23).
[[nodiscard]] std::optional<Eigen::VectorXd> minimise_quadratic(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                                                const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace fca::internal
