// SPDX-License-Identifier: BSD-3-Clause
#include "turn.h"

#include "../../rig/eigen_rotation.h"
#include "pixel_jacobian.h"
#include "turned_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

namespace fca::internal {

namespace {

using Samples = std::vector<Correspondence>;

/// A Gauss-Newton step: the changes of the unknowns, and the rms [px] after it if the errors were linear.
struct LinearStep {
  Eigen::VectorXd changes;
  double rms_px = 0.0;
};

/// The step that the derivatives (a column per unknown) and the residuals give. nullopt if it is not finite.
std::optional<LinearStep> linear_step(Eigen::MatrixXd derivatives, const Eigen::VectorXd& residuals) {
  // All columns are scaled to the length 1: those of coefficients of high powers and those of focal lengths have very different
  // lengths.
  const Eigen::VectorXd lengths = derivatives.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
  derivatives = derivatives * lengths.cwiseInverse().asDiagonal();
  // Some columns are almost linearly dependent. A rotation about the axis hardly changes the pixels of a round lens. In a
  // narrow lens other rotations are almost the same as a shift of the principal point.
  constexpr double kDependentColumns = 1e-7;  // relative size of a pivot
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(derivatives.rows(), derivatives.cols());
  solver.setThreshold(kDependentColumns);
  solver.compute(derivatives);
  const Eigen::VectorXd solution = solver.solve(-residuals);
  if (!solution.allFinite()) return std::nullopt;
  return LinearStep{solution.cwiseQuotient(lengths), (residuals + derivatives * solution).norm()};
}

/// The derivatives of the pixels of a fit's samples: by its free parameters, then by the angles of a rotation.
struct TurnDerivatives {
  Eigen::MatrixXd columns;
  Eigen::Index parameters = 0;  ///< The number of columns that are no angles.
  Eigen::VectorXd residuals;
};

/// Of a fit to `samples` without a rotation. nullopt if a sample has no pixel.
std::optional<TurnDerivatives> turn_derivatives(const FittedModel& fitted, const Samples& samples,
                                                std::span<const ParameterRange> ranges) {
  const std::optional<PixelJacobian> jacobian = jacobian_of(fitted.model, samples);
  if (!jacobian) return std::nullopt;
  const std::vector<Eigen::Index> free = free_columns(fitted.model, fitted.at_bound, ranges);
  const auto parameters = static_cast<Eigen::Index>(free.size());
  const Eigen::Index count = angle_count(fitted.model);
  TurnDerivatives result = {{}, parameters, jacobian->residuals};
  result.columns.resize(jacobian->columns.rows(), parameters + count);
  result.columns.leftCols(parameters) = jacobian->columns(Eigen::all, free);
  if (!write_angle_derivatives(fitted.model, samples, Eigen::Vector3d::Zero(), result.columns.rightCols(count)))
    return std::nullopt;
  return result;
}

/// The rotation vector [rad] of a step.
Eigen::Vector3d angles_of(const LinearStep& step, Eigen::Index parameters) {
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  const Eigen::Index count = step.changes.size() - parameters;
  angles.head(count) = step.changes.tail(count);
  return angles;
}

/// The samples with a positive weight.
Samples with_weight(std::span<const Correspondence> samples) {
  Samples result;
  std::ranges::copy_if(samples, std::back_inserter(result), [](const Correspondence& sample) { return sample.weight > 0.0; });
  return result;
}

}  // namespace

std::optional<TurnedFit> fit_with_turn(const FittedModel& start, std::span<const Correspondence> samples,
                                       std::span<const ParameterRange> ranges) {
  constexpr int kMostSteps = 30;
  constexpr int kMostHalvings = 8;
  constexpr double kNegligibleGain = 1e-4;  // fraction of the rms
  const Samples weighted = with_weight(samples);
  // The rms of `start` is over other samples. A fit to these samples makes it comparable.
  std::optional<FittedModel> best = fit_from(start.model, weighted, ranges);
  if (!best) return std::nullopt;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  bool is_turned = false;
  for (int i = 0; i < kMostSteps; ++i) {
    const std::optional<TurnDerivatives> derivatives = turn_derivatives(*best, rotated_samples(weighted, R), ranges);
    const std::optional<LinearStep> step =
        derivatives ? linear_step(derivatives->columns, derivatives->residuals) : std::nullopt;
    if (!step) break;
    const Eigen::Vector3d angles = angles_of(*step, derivatives->parameters);
    bool is_better = false;
    double gain = 0.0;
    double share = 1.0;
    for (int halving = 0; halving < kMostHalvings && !is_better; ++halving, share *= 0.5) {
      const Eigen::Matrix3d next = rotation_by(share * angles) * R;
      std::optional<FittedModel> fitted = fit_from(best->model, rotated_samples(weighted, next), ranges);
      is_better = fitted && fitted->reaches_all >= best->reaches_all && fitted->rms_px < best->rms_px;
      if (!is_better) continue;
      gain = 1.0 - fitted->rms_px / best->rms_px;
      fitted->iterations += best->iterations;
      best = std::move(fitted);
      R = next;
    }
    is_turned = is_turned || is_better;
    if (!is_better || gain < kNegligibleGain) break;
  }
  if (!is_turned) return std::nullopt;
  return TurnedFit{*std::move(best), transform_of(R)};
}

std::optional<TurnEstimate> estimate_turn(const FittedModel& fitted, std::span<const Correspondence> samples,
                                          std::span<const ParameterRange> ranges, double largest_ratio) {
  const std::optional<TurnDerivatives> derivatives = turn_derivatives(fitted, with_weight(samples), ranges);
  if (!derivatives) return std::nullopt;
  const std::optional<LinearStep> turned = linear_step(derivatives->columns, derivatives->residuals);
  // The parameters alone do no worse than no step at all: where the ratio to that is too large, so is the other.
  if (!turned || turned->rms_px >= largest_ratio * derivatives->residuals.norm()) return std::nullopt;
  const std::optional<LinearStep> without =
      linear_step(derivatives->columns.leftCols(derivatives->parameters), derivatives->residuals);
  if (!without || turned->rms_px >= largest_ratio * without->rms_px) return std::nullopt;
  return TurnEstimate{turned->rms_px / without->rms_px, angles_of(*turned, derivatives->parameters).norm()};
}

}  // namespace fca::internal
