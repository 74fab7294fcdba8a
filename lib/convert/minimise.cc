// SPDX-License-Identifier: BSD-3-Clause
#include "minimise.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

namespace fca::internal {

namespace {

/// The whole least-squares problem as P + 1 residuals: with J^T J = L L^T the residuals L^-1 J^T r and the rest of the cost, and
/// the Jacobian [L^T; 0], give the same gradient, the same normal equations and the same cost as all points do, so Ceres takes the
/// same steps on P + 1 rows.
class CompressedCost : public ceres::CostFunction {
 public:
  CompressedCost(const Accumulate& accumulate, int parameters) : accumulate_(accumulate) {
    set_num_residuals(parameters + 1);
    mutable_parameter_block_sizes()->push_back(parameters);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const int n = parameter_block_sizes()[0];
    const bool derivatives = jacobians != nullptr && jacobians[0] != nullptr;
    NormalEquations sums;
    if (!accumulate_(parameters[0], derivatives, sums) || !std::isfinite(sums.cost)) return false;
    Eigen::Map<Eigen::VectorXd> r(residuals, n + 1);
    r.setZero();
    r[n] = std::sqrt(sums.cost);
    if (!derivatives) return true;
    if (!sums.gradient.allFinite() || !sums.normal.allFinite()) return false;

    // LDLT, not LLT: parameters without influence leave the matrix singular.
    const Eigen::LDLT<Eigen::MatrixXd> factors(sums.normal);
    const Eigen::VectorXd d = factors.vectorD().cwiseMax(0.0);
    const double negligible = 1e-15 * d.maxCoeff();
    Eigen::MatrixXd rows = factors.transpositionsP() * Eigen::MatrixXd::Identity(n, n);
    rows = factors.matrixU() * rows;
    Eigen::VectorXd head = factors.matrixL().solve(factors.transpositionsP() * sums.gradient);
    for (int i = 0; i < n; ++i) {
      const double scale = d[i] > negligible ? std::sqrt(d[i]) : 0.0;
      rows.row(i) *= scale;
      head[i] = scale > 0.0 ? head[i] / scale : 0.0;
    }
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor> jacobian(jacobians[0], n + 1, n);
    jacobian.setZero();
    jacobian.topRows(n) = rows;
    r.head(n) = head;
    r[n] = std::sqrt(std::max(0.0, sums.cost - head.squaredNorm()));
    return true;
  }

 private:
  const Accumulate& accumulate_;
};

}  // namespace

Minimum minimise(const Accumulate& accumulate, int max_iterations, std::vector<double>& parameters) {
  NormalEquations sums;
  // Asked here, because Ceres would report a start it cannot evaluate on its log.
  if (!accumulate(parameters.data(), false, sums) || !std::isfinite(sums.cost)) return {};

  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  CompressedCost cost(accumulate, static_cast<int>(parameters.size()));
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, parameters.data());

  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.minimizer_progress_to_stdout = false;
  options.num_threads = 1;
  options.max_num_iterations = max_iterations;
  options.initial_trust_region_radius = 1e6;  // starts are good: begin close to Gauss-Newton
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-13;
  options.gradient_tolerance = 1e-16;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return {summary.IsSolutionUsable(), 2.0 * summary.final_cost,
          summary.num_successful_steps + summary.num_unsuccessful_steps};
}

}  // namespace fca::internal
