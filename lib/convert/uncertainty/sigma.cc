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

double worst_sigma(const TwoRows& jacobian, const Covariance& covariance) {
  const Eigen::Matrix2d of_pixel = jacobian * covariance * jacobian.transpose();
  const double mean = 0.5 * (of_pixel(0, 0) + of_pixel(1, 1));
  const double spread = std::hypot(0.5 * (of_pixel(0, 0) - of_pixel(1, 1)), 0.5 * (of_pixel(0, 1) + of_pixel(1, 0)));
  return std::sqrt(std::max(0.0, mean + spread));
}

double largest_sigma(const TwoRows& jacobian, const Eigen::VectorXd& sigmas) {
  std::vector<Eigen::Vector2d> sides;
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    Eigen::Vector2d side = jacobian.col(i) * sigmas[i];
    if (side[1] < 0.0 || (side[1] == 0.0 && side[0] < 0.0)) side = -side;
    sides.push_back(side);
    corner += side;
  }
  // All sides point to one half plane: turning them over one by one, by their angle, walks along half of the zonogon's corners.
  std::ranges::sort(sides, {}, [](const Eigen::Vector2d& side) { return std::atan2(side[1], side[0]); });
  double largest = corner.norm();
  for (const Eigen::Vector2d& side : sides) {
    corner -= 2.0 * side;
    largest = std::max(largest, corner.norm());
  }
  return largest;
}

}  // namespace fca::internal
