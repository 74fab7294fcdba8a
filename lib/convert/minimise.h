// SPDX-License-Identifier: BSD-3-Clause
// Levenberg-Marquardt over a handful of parameters and hundreds of points. The only door to Ceres' solver: everything above it
// compiles without Ceres' headers but for jet.h.
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace fca::internal {

/// Sums over all points: cost = sum w |r|^2, gradient = J^T W r, normal = J^T W J.
struct NormalEquations {
  double cost = 0.0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd normal;
};

/// Fills the sums at `parameters` (gradient and normal only if `derivatives`); false where a point cannot be projected: the
/// solver then rejects the step.
using Accumulate = std::function<bool(const double* parameters, bool derivatives, NormalEquations& sums)>;

struct Minimum {
  bool converged = false;  ///< false: not even the start could be evaluated
  double cost = 0.0;
  int iterations = 0;
};

/// Minimises the cost from `parameters`, in place.
Minimum minimise(const Accumulate& accumulate, int max_iterations, std::vector<double>& parameters);

}  // namespace fca::internal
