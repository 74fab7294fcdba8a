// SPDX-License-Identifier: BSD-3-Clause
// Levenberg-Marquardt over a handful of parameters and hundreds of points. The only door to Ceres' solver: everything above it
// compiles without Ceres' headers but for jet.h.
#pragma once

#include <functional>
#include <span>

namespace fca::internal {

/// Sums over all residuals r and their derivatives J (one column per parameter): what a step of the solver needs of them.
struct NormalEquations {
  double cost = 0.0;             ///< r'r
  std::span<double> gradient{};  ///< J'r
  std::span<double> hessian{};   ///< J'J, row-major; the upper triangle is enough
};

/// Evaluates at `parameters`; the sums of derivatives only where their spans are not empty. False where a point cannot be
/// projected: the solver then rejects the step.
using Evaluate = std::function<bool(const double* parameters, NormalEquations& sums)>;

struct Minimum {
  bool usable = false;  ///< false: not even the start could be evaluated
  double cost = 0.0;    ///< sum of squared residuals
  int iterations = 0;
};

/// Where a minimisation may end.
struct Effort {
  int max_iterations = 200;
  /// No further if a step gained less than this share of the cost.
  double relative_gain = 1e-12;
};

/// Minimises the sum of squared residuals from `parameters`, in place.
Minimum minimise(const Evaluate& evaluate, const Effort& effort, std::span<double> parameters);

}  // namespace fca::internal
