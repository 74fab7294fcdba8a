// SPDX-License-Identifier: BSD-3-Clause
#include "growing_fit.h"

#include "fit_limits.h"
#include "fitter.h"
#include "quadratic_program.h"
#include "sample_jacobian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fca::internal {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The conditions of a result must be at least kMinCondition (they are 1 on the axis). A smaller margin would let rounding end
/// the camera's domain before the outermost sample. The planes require the larger kPlaneCondition: a condition is slightly
/// below its tangent plane, and a camera on the plane must still meet kMinCondition.
constexpr double kPlaneCondition = 1e-6;
constexpr double kMinCondition = 0.5e-6;

/// The tangent of the samples' largest angle from the axis, increased by a factor of 1 + 1e-6. Infinite if this angle is 90
/// degrees or more.
double largest_tangent_of(std::span<const Correspondence> samples) {
  constexpr double kBeyondOutermost = 1.0 + 1e-6;
  double largest = 0.0;
  for (const Correspondence& s : samples) largest = std::max(largest, angle_from_axis(s.ray));
  return largest < 0.5 * std::numbers::pi ? std::tan(largest) * kBeyondOutermost : std::numeric_limits<double>::infinity();
}

/// A plane in the space of the free parameters p. It excludes the cameras with normal . p < offset.
struct Plane {
  VectorXd normal;
  double offset = 0.0;
};

/// The Gauss-Newton iteration of fit_growing().
class Descent {
 public:
  Descent(const GrowingTask& task, const ParameterValues& start)
      : task_(task),
        parameter_count_(task.target.parameters().size()),
        limits_(task.target, task.ranges),
        largest_tangent_(largest_tangent_of(task.samples)),
        jacobian_(task.target),
        at_(start) {
    std::array<bool, kMostParameters> fixed{};
    for (std::size_t i = 0; i < parameter_count_; ++i) {
      at_[i] = std::clamp(at_[i], limits_.lower[i], limits_.upper[i]);
      fixed[i] = limits_.fixed(i);
      if (!fixed[i]) free_.push_back(i);
    }
    jacobian_.reset({task.samples.begin(), task.samples.end()}, fixed);
  }

  /// True if the growth conditions hold for the start, all samples are less than 90 degrees from the axis, and a parameter is
  /// free.
  [[nodiscard]] bool can_run() const { return std::isfinite(largest_tangent_) && !free_.empty() && grows(at_); }
  [[nodiscard]] const ParameterValues& values() const { return at_; }
  [[nodiscard]] int iterations() const { return iterations_; }

  void run() {
    constexpr int kMostSteps = 100;
    while (iterations_ < kMostSteps && take_step()) ++iterations_;
  }

 private:
  [[nodiscard]] Index free_count() const { return static_cast<Index>(free_.size()); }

  /// True if the camera's radius grows up to `largest_tangent_`.
  [[nodiscard]] bool grows(const ParameterValues& values) const {
    return std::ranges::all_of(task_.conditions, [&](GrowthCondition condition) {
      return minima_below(kMinCondition, condition, values.data(), largest_tangent_).empty();
    });
  }

  /// The elements of `values` that belong to free parameters.
  [[nodiscard]] VectorXd free_of(const double* values) const {
    VectorXd result(free_count());
    for (Index i = 0; i < free_count(); ++i) result[i] = values[free_[static_cast<std::size_t>(i)]];
    return result;
  }

  /// All parameters of the camera with the free parameters p, moved into their ranges.
  [[nodiscard]] ParameterValues values_at(const VectorXd& p) const {
    ParameterValues values = at_;
    for (Index i = 0; i < free_count(); ++i) {
      const std::size_t k = free_[static_cast<std::size_t>(i)];
      values[k] = std::clamp(p[i], limits_.lower[k], limits_.upper[k]);
    }
    return values;
  }

  /// Adds planes that exclude this camera if its radius stops growing before `largest_tangent_`: one plane for each minimum
  /// over r of a condition that is too small there, tangent to the condition. True if it added a plane.
  bool add_planes(const ParameterValues& values) {
    constexpr std::size_t kMostPlanes = 200;
    bool added = false;
    for (const GrowthCondition condition : task_.conditions) {
      for (const double r : minima_below(kMinCondition, condition, values.data(), largest_tangent_)) {
        ParameterValues derivatives{};
        const double value = condition(values.data(), r, derivatives.data());
        Plane plane{free_of(derivatives.data()), 0.0};
        plane.offset = kPlaneCondition - value + plane.normal.dot(free_of(values.data()));
        if (plane.normal.isZero(0.0) || planes_.size() >= kMostPlanes) continue;
        planes_.push_back(std::move(plane));
        added = true;
      }
    }
    return added;
  }

  /// The step to the minimum of the quadratic with this Hessian and gradient, among the cameras within the ranges that no plane
  /// excludes. nullopt if there is no such camera, or the Hessian is not positive definite.
  [[nodiscard]] std::optional<VectorXd> step_among_planes(const MatrixXd& hessian, const VectorXd& gradient) const {
    const Index n = free_count();
    const VectorXd here = free_of(at_.data());
    const auto cuts = static_cast<Index>(planes_.size());
    MatrixXd normals(2 * n + cuts, n);
    VectorXd offsets(2 * n + cuts);
    normals.topRows(n) = MatrixXd::Identity(n, n);
    normals.middleRows(n, n) = -MatrixXd::Identity(n, n);
    offsets.head(n) = free_of(limits_.lower.data()) - here;
    offsets.segment(n, n) = here - free_of(limits_.upper.data());
    for (Index i = 0; i < cuts; ++i) {
      const Plane& plane = planes_[static_cast<std::size_t>(i)];
      normals.row(2 * n + i) = plane.normal.transpose();
      offsets[2 * n + i] = plane.offset - plane.normal.dot(here);
    }
    return minimise_quadratic(hessian, gradient, normals, offsets);
  }

  /// Like step_among_planes(), but adds planes until the radius of the camera at the step's end grows up to `largest_tangent_`.
  [[nodiscard]] std::optional<VectorXd> step_among_growing(const MatrixXd& hessian, const VectorXd& gradient) {
    constexpr int kMostRounds = 40;
    std::optional<VectorXd> step;
    for (int i = 0; i < kMostRounds; ++i) {
      step = step_among_planes(hessian, gradient);
      if (!step || !add_planes(values_at(free_of(at_.data()) + *step))) break;
    }
    return step;
  }

  /// Takes a Gauss-Newton step, halved until the cost falls and the radius grows. False if there is no such step, or the cost
  /// falls by at most a fraction of 1e-9.
  bool take_step() {
    constexpr double kNegligibleGain = 1e-9;   // fraction of the cost
    constexpr double kNegligibleCost = 1e-20;  // px^2
    constexpr int kMostHalvings = 20;
    const Index n = free_count();
    VectorXd gradient(n);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> hessian(n, n);
    NormalEquations sums{0.0, {gradient.data(), free_.size()}, {hessian.data(), free_.size() * free_.size()}};
    if (!jacobian_.evaluate(at_, sums)) return false;
    hessian.triangularView<Eigen::StrictlyLower>() = hessian.transpose();
    const std::optional<VectorXd> step = step_among_growing(hessian, gradient);
    if (!step) return false;
    const double expected_gain = -(2.0 * gradient.dot(*step) + step->dot(hessian * *step));
    if (!(expected_gain > kNegligibleGain * sums.cost + kNegligibleCost)) return false;
    double share = 1.0;
    for (int halving = 0; halving < kMostHalvings; ++halving, share *= 0.5) {
      const ParameterValues next = values_at(free_of(at_.data()) + share * *step);
      NormalEquations cost;
      if (!grows(next) || !jacobian_.evaluate(next, cost) || !(cost.cost < sums.cost)) continue;
      at_ = next;
      return sums.cost - cost.cost > kNegligibleGain * sums.cost;
    }
    return false;
  }

  const GrowingTask& task_;
  std::size_t parameter_count_;
  FitLimits limits_;
  double largest_tangent_;  ///< The tan of the angle up to which the radius must grow.
  SampleJacobian jacobian_;
  ParameterValues at_;             ///< The current camera.
  std::vector<std::size_t> free_;  ///< Indices of the parameters that may change.
  std::vector<Plane> planes_;      ///< They exclude only cameras with a condition below kPlaneCondition.
  int iterations_ = 0;
};

}  // namespace

std::optional<FoundFit> fit_growing(const GrowingTask& task, const ParameterValues& start) {
  Descent descent(task, start);
  if (!descent.can_run()) return std::nullopt;
  descent.run();
  std::optional<FoundFit> found = Fitter(task.target, task.samples, task.ranges).evaluate_camera(descent.values());
  if (found) found->iterations = descent.iterations();
  return found;
}

}  // namespace fca::internal
