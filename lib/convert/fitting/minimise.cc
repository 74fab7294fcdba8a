// SPDX-License-Identifier: BSD-3-Clause
#include "minimise.h"

#include <fca/convert/fit_target.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ceres/tiny_solver.h>
#include <Eigen/Core>

namespace fca::internal {

namespace {

/// The cost in the form that Ceres' TinySolver needs, with few residuals. For P parameters, let J'J = L L' and L w = J'r. The P
/// + 1 residuals [w; sqrt(r'r - w'w)] and their Jacobian [L'; 0] then have the same cost, gradient and normal equations as the
/// hundreds of residuals r that they replace. (LIMITS.md: the fit takes a fifth of the time of a Ceres problem with a block per
/// point.)
///
/// kSize is the number of parameters that the solver sees, or Eigen::Dynamic. If it is larger than the real number, the
/// additional parameters have no effect.
template <int kSize>
class CompressedCost {
 public:
  using Scalar = double;
  // ceres::TinySolver requires these names.
  enum {
    NUM_RESIDUALS = kSize == Eigen::Dynamic ? Eigen::Dynamic : kSize + 1,  // NOLINT(readability-identifier-naming)
    NUM_PARAMETERS = kSize                                                 // NOLINT(readability-identifier-naming)
  };
  [[nodiscard]] int NumParameters() const { return size_; }     // NOLINT(readability-identifier-naming)
  [[nodiscard]] int NumResiduals() const { return size_ + 1; }  // NOLINT(readability-identifier-naming)

  CompressedCost(const Evaluate& evaluate, std::size_t count)
      : evaluate_(evaluate), count_(count), size_(kSize == Eigen::Dynamic ? static_cast<int>(count) : kSize) {}

  /// TinySolver ignores the return value of a trial step (`jacobian` is null). The cost of a step that cannot be evaluated is
  /// therefore higher than any other.
  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    std::fill_n(residuals, size_ + 1, 0.0);
    NormalEquations sums;
    if (jacobian == nullptr) {
      constexpr double kInvalidResidual = 1e100;
      const bool valid = evaluate_(parameters, sums) && std::isfinite(sums.cost);
      residuals[size_] = valid ? std::sqrt(sums.cost) : kInvalidResidual;
      return valid;
    }
    Eigen::Matrix<double, kSize, kSize> hessian = Eigen::Matrix<double, kSize, kSize>::Zero(size_, size_);
    Eigen::Matrix<double, kSize, 1> gradient = Eigen::Matrix<double, kSize, 1>::Zero(size_);
    sums.gradient = std::span(gradient.data(), count_);
    sums.hessian = std::span(hessian.data(), count_ * count_);
    std::fill_n(jacobian, (size_ + 1) * size_, 0.0);
    if (!evaluate_(parameters, sums) || !std::isfinite(sums.cost)) return false;
    compress(sums, residuals, jacobian);
    return true;
  }

 private:
  [[nodiscard]] std::size_t rows() const { return kSize == Eigen::Dynamic ? count_ + 1 : static_cast<std::size_t>(kSize) + 1; }

  /// Computes L by Cholesky's method, and the residuals.
  void compress(const NormalEquations& sums, double* residuals, double* jacobian) const {
    // Column-major: element (row i of L', column j) = L_ji is jacobian[j * rows() + i].
    const auto lower = [this, jacobian](std::size_t j, std::size_t i) -> double& { return jacobian[j * rows() + i]; };
    double rest = sums.cost;
    for (std::size_t i = 0; i < count_; ++i) {
      double pivot = sums.hessian[i * count_ + i];
      const double smallest = std::numeric_limits<double>::epsilon() * pivot;
      for (std::size_t k = 0; k < i; ++k) pivot -= lower(i, k) * lower(i, k);
      // The earlier columns of J span this one, but for rounding errors: its column of L remains 0.
      if (!(pivot > smallest)) continue;
      const double root = std::sqrt(pivot);
      lower(i, i) = root;
      double w = sums.gradient[i];
      for (std::size_t k = 0; k < i; ++k) w -= lower(i, k) * residuals[k];
      residuals[i] = w / root;
      rest -= residuals[i] * residuals[i];
      for (std::size_t j = i + 1; j < count_; ++j) {
        double sum = sums.hessian[i * count_ + j];
        for (std::size_t k = 0; k < i; ++k) sum -= lower(i, k) * lower(j, k);
        lower(j, i) = sum / root;
      }
    }
    residuals[size_] = std::sqrt(std::max(0.0, rest));
  }

  const Evaluate& evaluate_;
  std::size_t count_;
  int size_;
};

/// Minimises with a solver for kSize parameters, of which the first parameters.size() are used.
template <int kSize>
Minimum minimise_padded(const Evaluate& evaluate, const Effort& effort, double start_cost, std::span<double> parameters) {
  const CompressedCost<kSize> cost(evaluate, parameters.size());
  ceres::TinySolver<CompressedCost<kSize>> solver;
  using Parameters = typename ceres::TinySolver<CompressedCost<kSize>>::Parameters;
  Parameters x = Parameters::Zero(cost.NumParameters());
  std::ranges::copy(parameters, x.data());

  solver.options.initial_trust_region_radius = 1e6;  // starts are good: little damping, close to Gauss-Newton
  solver.options.gradient_tolerance = 0.0;
  solver.options.cost_threshold = 0.0;
  solver.options.parameter_tolerance = 1e-15;
  // TinySolver's tolerance of the cost is absolute [px^2], that of Effort is relative. The first tolerance is relative to the
  // cost at the start. If the cost becomes much smaller, the solver continues with a tolerance relative to the new cost.
  constexpr double kNegligibleGain = 1e-13;  // px^2
  double tolerance = std::max(kNegligibleGain, effort.relative_gain * start_cost);
  Minimum minimum{true, start_cost, 0};
  for (;;) {
    solver.options.function_tolerance = tolerance;
    solver.options.max_num_iterations = effort.max_iterations - minimum.iterations;
    const auto& summary = solver.Solve(cost, &x);
    minimum.iterations += std::max(1, summary.iterations);
    minimum.cost = 2.0 * summary.final_cost;
    constexpr double kExactGain = 1e-24;  // px^2; smaller gains are rounding errors
    constexpr double kMuchSmallerRatio = 100.0;
    const double next_tolerance = std::max(kExactGain, effort.relative_gain * minimum.cost);
    if (tolerance < kMuchSmallerRatio * next_tolerance || minimum.iterations >= effort.max_iterations) break;
    tolerance = next_tolerance;
  }
  std::copy_n(x.data(), parameters.size(), parameters.begin());
  return minimum;
}

}  // namespace

Minimum minimise(const Evaluate& evaluate, const Effort& effort, std::span<double> parameters) {
  NormalEquations sums;
  if (!evaluate(parameters.data(), sums) || !std::isfinite(sums.cost)) return {};
  // The number of parameters is rounded up to one of a few sizes: a template instance for each number would take long to
  // compile.
  constexpr int kSmallest = 2;
  constexpr int kSmall = 6;
  constexpr int kMiddle = 9;
  constexpr int kLarge = 14;
  constexpr int kLargest = kMostParameters;
  if (parameters.size() <= kSmallest) return minimise_padded<kSmallest>(evaluate, effort, sums.cost, parameters);
  if (parameters.size() <= kSmall) return minimise_padded<kSmall>(evaluate, effort, sums.cost, parameters);
  if (parameters.size() <= kMiddle) return minimise_padded<kMiddle>(evaluate, effort, sums.cost, parameters);
  if (parameters.size() <= kLarge) return minimise_padded<kLarge>(evaluate, effort, sums.cost, parameters);
  if (parameters.size() <= kLargest) return minimise_padded<kLargest>(evaluate, effort, sums.cost, parameters);
  return minimise_padded<Eigen::Dynamic>(evaluate, effort, sums.cost, parameters);
}

}  // namespace fca::internal
