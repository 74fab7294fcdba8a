// SPDX-License-Identifier: BSD-3-Clause
// The Levenberg-Marquardt method for a few parameters and hundreds of points. Only minimise.cc includes Ceres' solver.
#pragma once

#include <functional>
#include <span>

namespace fca::internal {

/// Sums over all residuals r [px] and their Jacobian J (one column per parameter). The solver computes a step from these.
struct NormalEquations {
  double cost = 0.0;             ///< r'r
  std::span<double> gradient{};  ///< J'r
  std::span<double> hessian{};   ///< J'J, row-major; the upper triangle is enough
};

/// Computes the cost at `parameters`, and gradient and Hessian unless their spans are empty. False if that is not possible, as
/// when a point has no pixel. The solver then rejects the step.
using Evaluate = std::function<bool(const double* parameters, NormalEquations& sums)>;

/// The result of minimise().
struct Minimum {
  bool usable = false;  ///< False if the start could not be evaluated.
  double cost = 0.0;    ///< Sum of squared residuals.
  int iterations = 0;
};

/// When a minimisation ends.
struct Effort {
  int max_iterations = 200;
  /// The minimisation ends after a step that reduces the cost by less than this fraction.
  double relative_gain = 1e-12;
};

/// Minimises the sum of squared residuals, starting from `parameters`, which receives the result. If the start cannot be
/// evaluated, `parameters` remains unchanged.
Minimum minimise(const Evaluate& evaluate, const Effort& effort, std::span<double> parameters);

}  // namespace fca::internal
