// SPDX-License-Identifier: BSD-3-Clause
#include "sigma.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fca::internal {

Covariance covariance_of(const Uncertainty& uncertainty) {
  const auto count = static_cast<Eigen::Index>(uncertainty.sigmas.size());
  return {uncertainty.covariance.data(), count, count};
}

void set_covariance(const Eigen::MatrixXd& covariance, Uncertainty& uncertainty) {
  uncertainty.sigmas.clear();
  uncertainty.covariance.clear();
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    uncertainty.sigmas.push_back(std::sqrt(std::max(0.0, covariance(i, i))));
    for (Eigen::Index j = 0; j < covariance.cols(); ++j) uncertainty.covariance.push_back(covariance(i, j));
  }
}

double sigma_of_pixel(const ParameterJacobian& jacobian, const Covariance& covariance) {
  const Eigen::Matrix2d pixel_covariance = jacobian * covariance * jacobian.transpose();
  // The larger eigenvalue of a symmetric 2 x 2 matrix is the mean of both eigenvalues plus half of their difference.
  const double mean = 0.5 * (pixel_covariance(0, 0) + pixel_covariance(1, 1));
  const double half_difference = std::hypot(0.5 * (pixel_covariance(0, 0) - pixel_covariance(1, 1)),
                                            0.5 * (pixel_covariance(0, 1) + pixel_covariance(1, 0)));
  return std::sqrt(std::max(0.0, mean + half_difference));
}

double sigma_bound_of_pixel(const ParameterJacobian& jacobian, const Eigen::VectorXd& sigmas) {
  // The sums of c_i J_i sigma_i with -1 <= c_i <= 1 fill a polygon that is symmetric about 0, with the sides 2 J_i sigma_i. The
  // bound is the distance of its farthest corner from 0: the largest sigma that any correlations can give. The sum of all
  // vectors, each turned into the upper half plane, is one corner. Subtracting twice each vector, in the order of their angles,
  // gives the next corners. The remaining corners are mirror images of these.
  std::vector<Eigen::Vector2d> half_sides;
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    Eigen::Vector2d half_side = jacobian.col(i) * sigmas[i];
    if (half_side[1] < 0.0 || (half_side[1] == 0.0 && half_side[0] < 0.0)) half_side = -half_side;
    half_sides.push_back(half_side);
    corner += half_side;
  }
  std::ranges::sort(half_sides, {}, [](const Eigen::Vector2d& vector) { return std::atan2(vector[1], vector[0]); });
  double largest = corner.norm();
  for (const Eigen::Vector2d& half_side : half_sides) {
    corner -= 2.0 * half_side;
    largest = std::max(largest, corner.norm());
  }
  return largest;
}

}  // namespace fca::internal
