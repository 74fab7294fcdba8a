// SPDX-License-Identifier: BSD-3-Clause
// Functions for fits that rotate a camera.
#pragma once

#include <fca/convert/fit_target.h>
#include <fca/models/camera_model.h>

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace fca::internal {

/// The samples with their rays rotated by R (new ray = R ray).
[[nodiscard]] std::vector<Correspondence> turned(std::span<const Correspondence> samples, const Eigen::Matrix3d& R);

/// The number of rotation angles to fit: 3, or 2 (a tilt of the axis) for a model with an affine part (c, d, e of ocamcalib),
/// which can represent a rotation about the axis itself.
[[nodiscard]] Eigen::Index angles_of(const CameraModel& model);

/// Writes the derivatives of the rotated samples' pixels by the first components of the rotation vector `angles` [rad], one per
/// column, with rows like those of a PixelJacobian [px/rad]. False if a ray has no pixel.
[[nodiscard]] bool put_derivatives_by_angles(const CameraModel& model, std::span<const Correspondence> samples,
                                             const Eigen::Vector3d& angles, Eigen::Ref<Eigen::MatrixXd> columns);

/// Indices of the parameters that a further fit may change: those neither fixed by the ranges nor at a bound.
[[nodiscard]] std::vector<Eigen::Index> free_columns(const CameraModel& model, std::span<const std::string> at_bound,
                                                     std::span<const ParameterRange> ranges);

}  // namespace fca::internal
