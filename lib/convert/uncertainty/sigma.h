// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>

#include <fca/rig/uncertainty.h>

namespace fca::internal {

using TwoRows = Eigen::Matrix<double, 2, Eigen::Dynamic>;
using Covariance = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

[[nodiscard]] Covariance covariance_of(const Uncertainty& uncertainty);

/// The numbers of a symmetric matrix and the roots of its diagonal, as an Uncertainty has them.
void set_covariance(const Eigen::MatrixXd& covariance, Uncertainty& uncertainty);

/// The root of the larger eigenvalue of J C J'.
[[nodiscard]] double worst_sigma(const TwoRows& jacobian, const Covariance& covariance);

/// The largest worst_sigma() over all correlations: max over directions e of sum_i |e . J_i| sigma_i, half the diameter of the
/// zonogon with sides 2 J_i sigma_i.
[[nodiscard]] double largest_sigma(const TwoRows& jacobian, const Eigen::VectorXd& sigmas);

}  // namespace fca::internal
