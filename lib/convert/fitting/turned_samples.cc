// SPDX-License-Identifier: BSD-3-Clause
#include "turned_samples.h"

#include "../../rig/eigen_rotation.h"
#include "fit_limits.h"
#include "fit_model.h"
#include "pixel_jacobian.h"

#include <fca/rig/rotation.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace fca::internal {

std::vector<Correspondence> rotated_samples(std::span<const Correspondence> samples, const Eigen::Matrix3d& R) {
  const Transform T = transform_of(R);
  std::vector<Correspondence> result(samples.begin(), samples.end());
  for (Correspondence& sample : result) sample.ray = rotated(T, sample.ray);
  return result;
}

Eigen::Index angle_count(const CameraModel& model) {
  const std::span<const Parameter> parameters = model_info(model).parameters;
  const auto has = [&parameters](std::string_view name) {
    return std::ranges::find(parameters, name, &Parameter::name) != parameters.end();
  };
  constexpr Eigen::Index kTilt = 2;  // about x and y
  constexpr Eigen::Index kRotation = 3;
  return has("c") && has("d") && has("e") ? kTilt : kRotation;
}

bool write_angle_derivatives(const CameraModel& model, std::span<const Correspondence> samples, const Eigen::Vector3d& angles,
                             Eigen::Ref<Eigen::MatrixXd> columns) {
  constexpr double kStep = 1e-6;  // rad
  for (Eigen::Index axis = 0; axis < columns.cols(); ++axis) {
    const Eigen::Vector3d along = kStep * Eigen::Vector3d::Unit(axis);
    const std::optional<Eigen::VectorXd> before = residuals_of(model, rotated_samples(samples, rotation_by(angles - along)));
    const std::optional<Eigen::VectorXd> after = residuals_of(model, rotated_samples(samples, rotation_by(angles + along)));
    if (!before || !after) return false;
    columns.col(axis) = (*after - *before) / (2.0 * kStep);
  }
  return true;
}

std::vector<Eigen::Index> free_columns(const CameraModel& model, std::span<const std::string> at_bound,
                                       std::span<const ParameterRange> ranges) {
  const std::unique_ptr<FitTarget> target = fit_target_of(model);
  const FitLimits limits(*target, ranges);
  std::vector<Eigen::Index> free;
  for (std::size_t i = 0; i < target->parameters().size(); ++i) {
    const bool is_at_bound = std::ranges::find(at_bound, target->parameters()[i].name) != at_bound.end();
    if (!limits.fixed(i) && !is_at_bound) free.push_back(static_cast<Eigen::Index>(i));
  }
  return free;
}

}  // namespace fca::internal
