// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <optional>

#include <fca/rig/uncertainty.h>

namespace fca::internal {

/// Of a pixel by the parameters: u and v, px per unit of each parameter.
using ParameterJacobian = Eigen::Matrix<double, 2, Eigen::Dynamic>;
using Covariance = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// The full covariance of the parameters, which `uncertainty` has. Valid while that lives.
[[nodiscard]] Covariance covariance_of(const Uncertainty& uncertainty);

/// Stores a covariance (symmetric, one row a parameter) and the standard deviations, the roots of its diagonal.
void set_covariance(const Eigen::MatrixXd& covariance, Uncertainty& uncertainty);

/// The standard deviation [px] of the pixel in the direction where it is largest: the root of the larger eigenvalue of J C J'.
[[nodiscard]] double sigma_of_pixel(const ParameterJacobian& jacobian, const Covariance& covariance);

/// The same [px] where only the standard deviations of the parameters are known: the largest that any correlations give. It is
/// the maximum over directions e of sum_i |e . J_i| sigma_i.
[[nodiscard]] double sigma_bound_of_pixel(const ParameterJacobian& jacobian, const Eigen::VectorXd& sigmas);

}  // namespace fca::internal
