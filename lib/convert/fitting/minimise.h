// SPDX-License-Identifier: BSD-3-Clause
// Levenberg-Marquardt over a few parameters and hundreds of points. Only minimise.cc includes Ceres' solver.
#pragma once

#include <functional>
#include <span>

namespace fca::internal {

/// Sums over all residuals r and their Jacobian J (one column per parameter), from which the solver computes a step.
struct NormalEquations {
  double cost = 0.0;             ///< r'r
  std::span<double> gradient{};  ///< J'r
  std::span<double> hessian{};   ///< J'J, row-major; the upper triangle is enough
};

/// Computes the cost at `parameters`, and gradient and Hessian unless their spans are empty. False if a point has no pixel; the
/// solver then rejects the step.
using Evaluate = std::function<bool(const double* parameters, NormalEquations& sums)>;

struct Minimum {
  bool usable = false;  ///< false: not even the start could be evaluated
  double cost = 0.0;    ///< sum of squared residuals
  int iterations = 0;
};

/// When a minimisation ends.
struct Effort {
  int max_iterations = 200;
  /// It ends after a step that reduces the cost by less than this fraction.
  double relative_gain = 1e-12;
};

/// Minimises the sum of squared residuals, starting from `parameters`, which receive the result.
Minimum minimise(const Evaluate& evaluate, const Effort& effort, std::span<double> parameters);

}  // namespace fca::internal
