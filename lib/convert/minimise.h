// SPDX-License-Identifier: BSD-3-Clause
// Levenberg-Marquardt over a handful of parameters and hundreds of points. The only door to Ceres' solver: everything above it
// compiles without Ceres' headers but for jet.h.
#pragma once

#include <functional>
#include <vector>

namespace fca::internal {

/// Fills `residuals` and, unless it is null, `jacobian` (row-major, one row per residual, one column per parameter). False
/// where a point cannot be projected: the solver then rejects the step.
using Residuals = std::function<bool(const double* parameters, double* residuals, double* jacobian)>;

struct Minimum {
  bool usable = false;  ///< false: not even the start could be evaluated
  double cost = 0.0;    ///< sum of squared residuals
  int iterations = 0;
};

/// Minimises the sum of squared residuals from `parameters`, in place.
Minimum minimise(const Residuals& evaluate, int residuals, int max_iterations, std::vector<double>& parameters);

}  // namespace fca::internal
