// SPDX-License-Identifier: BSD-3-Clause
// Standard deviations of pixels that follow from those of a camera's parameters. README.md has the derivation.
#pragma once

#include <Eigen/Core>

#include <optional>

#include <fca/rig/uncertainty.h>

namespace fca::internal {

/// The derivatives of a pixel (u, v) with respect to the parameters, in px per unit of each parameter: 2 x n.
using ParameterJacobian = Eigen::Matrix<double, 2, Eigen::Dynamic>;
/// A covariance of n parameters, n x n. The numbers belong to an Uncertainty.
using Covariance = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// Returns a view of the covariance in `uncertainty`, which must contain one. The view is valid as long as `uncertainty`
/// exists.
[[nodiscard]] Covariance covariance_of(const Uncertainty& uncertainty);

/// Stores a covariance (symmetric, one row per parameter) in `uncertainty`, and as standard deviations the square roots of its
/// diagonal.
void set_covariance(const Eigen::MatrixXd& covariance, Uncertainty& uncertainty);

/// The standard deviation [px] of a pixel along the direction in which it is largest: the square root of the larger eigenvalue
/// of J C J', with the Jacobian J and the covariance C.
[[nodiscard]] double sigma_of_pixel(const ParameterJacobian& jacobian, const Covariance& covariance);

/// An upper bound of sigma_of_pixel() [px] if only the standard deviations of the parameters are known: its largest value over
/// all possible correlations. It is the maximum over unit vectors e of sum_i |e . J_i| sigma_i, with the columns J_i.
[[nodiscard]] double sigma_bound_of_pixel(const ParameterJacobian& jacobian, const Eigen::VectorXd& sigmas);

}  // namespace fca::internal
