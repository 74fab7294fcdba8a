// SPDX-License-Identifier: BSD-3-Clause
// Functions for fits of a rotation of the camera.
#pragma once

#include <fca/convert/fit_target.h>
#include <fca/models/camera_model.h>

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace fca::internal {

/// Returns the samples with their rays rotated by R (new ray = R ray).
[[nodiscard]] std::vector<Correspondence> rotated_samples(std::span<const Correspondence> samples, const Eigen::Matrix3d& R);

/// The number of rotation angles that a fit of the model has. It is 2, a tilt of the axis, for a model with an affine part (c,
/// d, e of ocamcalib), whose parameters can represent a rotation about the axis. It is 3 for every other model.
[[nodiscard]] Eigen::Index angle_count(const CameraModel& model);

/// Writes the derivatives [px/rad] of the pixels of samples that are rotated by the rotation vector `angles` [rad]. Column i
/// holds the derivatives with respect to the component i of this vector. The number of columns may be less than 3. The rows are
/// those of a PixelJacobian. False if a ray has no pixel.
[[nodiscard]] bool write_angle_derivatives(const CameraModel& model, std::span<const Correspondence> samples,
                                           const Eigen::Vector3d& angles, Eigen::Ref<Eigen::MatrixXd> columns);

/// Indices of the parameters that a further fit may change: those that the ranges do not fix, and that are not at a bound.
[[nodiscard]] std::vector<Eigen::Index> free_columns(const CameraModel& model, std::span<const std::string> at_bound,
                                                     std::span<const ParameterRange> ranges);

}  // namespace fca::internal
