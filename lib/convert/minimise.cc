// SPDX-License-Identifier: BSD-3-Clause
#include "minimise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

namespace fca::internal {

namespace {

/// All points as one residual block: per-point blocks cost twice the time (LIMITS.md, speed of the core).
class BatchedCost : public ceres::CostFunction {
 public:
  BatchedCost(const Residuals& evaluate, int residuals, int parameters) : evaluate_(evaluate) {
    set_num_residuals(residuals);
    mutable_parameter_block_sizes()->push_back(parameters);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    double* const jacobian = jacobians != nullptr ? jacobians[0] : nullptr;
    if (!evaluate_(parameters[0], residuals, jacobian)) return false;
    // A derivative that is no number (at an edge of the domain) would be reported on Ceres' log, whatever the logging type is.
    if (jacobian != nullptr) {
      std::replace_if(
          jacobian, jacobian + num_residuals() * parameter_block_sizes()[0], [](double d) { return !std::isfinite(d); }, 0.0);
    }
    return true;
  }

 private:
  const Residuals& evaluate_;
};

}  // namespace

Minimum minimise(const Residuals& evaluate, int residuals, int max_iterations, std::vector<double>& parameters) {
  // Asked here, because Ceres would report a start it cannot evaluate on its log.
  std::vector<double> start(static_cast<std::size_t>(residuals));
  if (!evaluate(parameters.data(), start.data(), nullptr)) return {};
  if (!std::isfinite(std::inner_product(start.begin(), start.end(), start.begin(), 0.0))) return {};

  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  BatchedCost cost(evaluate, residuals, static_cast<int>(parameters.size()));
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, parameters.data());

  ceres::Solver::Options options;
  // QR, not the normal equations: the models' valleys are so flat that squaring their condition number loses the way.
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.max_num_consecutive_invalid_steps = max_iterations + 1;  // running into this limit would be logged
  options.max_num_iterations = max_iterations;
  options.initial_trust_region_radius = 1e6;  // starts are good: begin close to Gauss-Newton
  options.max_trust_region_radius = 1e32;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-14;
  options.gradient_tolerance = 1e-18;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {summary.IsSolutionUsable(), 2.0 * summary.final_cost, summary.num_successful_steps + summary.num_unsuccessful_steps};
}

}  // namespace fca::internal
