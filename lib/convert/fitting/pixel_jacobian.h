// SPDX-License-Identifier: BSD-3-Clause
// The derivatives of pixels with respect to the parameters of a camera.
#pragma once

#include <fca/convert/fit_target.h>
#include <fca/models/camera_model.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// The residuals of samples and their derivatives. The rows are those of u for all samples, then those of v, each times the
/// square root of the sample's weight.
struct PixelJacobian {
  /// The derivatives of the model's pixels with respect to the parameters, in px per unit of each parameter; one column per
  /// parameter.
  Eigen::MatrixXd columns;
  Eigen::VectorXd residuals;  ///< The model's pixel minus the sample's pixel [px].

  /// The two rows (u, v) of the derivatives of one sample.
  [[nodiscard]] Eigen::Matrix<double, 2, Eigen::Dynamic> of(Eigen::Index sample) const {
    Eigen::Matrix<double, 2, Eigen::Dynamic> rows(2, columns.cols());
    rows << columns.row(sample), columns.row(columns.rows() / 2 + sample);
    return rows;
  }
};

/// The residuals of a camera and their derivatives. nullopt if a sample's ray has no pixel, or a number is not finite.
[[nodiscard]] std::optional<PixelJacobian> jacobian_of(const CameraModel& model, std::span<const Correspondence> samples);

/// The residuals of jacobian_of() alone. nullopt if a sample's ray has no pixel.
[[nodiscard]] std::optional<Eigen::VectorXd> residuals_of(const CameraModel& model, std::span<const Correspondence> samples);

/// Indices of the parameters that a fit may have changed. These are all except those with names in `held`, the lens parameters
/// that are 0, and those that fits of the model leave at their start (FitTarget::held).
[[nodiscard]] std::vector<std::size_t> free_parameters(const CameraModel& model, std::span<const std::string> held);

}  // namespace fca::internal
