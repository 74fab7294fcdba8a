// SPDX-License-Identifier: BSD-3-Clause
// What fits that turn a camera have in common.
#pragma once

#include <fca/convert/fit_target.h>
#include <fca/models/camera_model.h>

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace fca::internal {

/// The same pixels with their rays turned.
[[nodiscard]] std::vector<Correspondence> turned(std::span<const Correspondence> samples, const Eigen::Matrix3d& R);

/// The angles by which a camera is turned: three, or the two that tilt its axis where the model has an affine part (c, d, e of
/// ocamcalib), in which a turn about the axis hides.
[[nodiscard]] Eigen::Index angles_of(const CameraModel& model);

/// Puts into `columns` the derivatives of the turned samples' pixels by the first numbers of the rotation vector
/// `angles` [rad], one for each column, in rows like those of a PixelJacobian; false where a ray has no pixel.
[[nodiscard]] bool put_slopes_of_angles(const CameraModel& model, std::span<const Correspondence> samples,
                                        const Eigen::Vector3d& angles, Eigen::Ref<Eigen::MatrixXd> columns);

/// Indices of the parameters that a further fit may move: those that are neither fixed by the ranges nor ended at a bound.
[[nodiscard]] std::vector<Eigen::Index> free_columns(const CameraModel& model, std::span<const std::string> at_bound,
                                                     std::span<const ParameterRange> ranges);

}  // namespace fca::internal
