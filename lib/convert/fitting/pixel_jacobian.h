// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/fit_target.h>
#include <fca/models/camera_model.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// Derivatives of pixels by each parameter, times the square root of the sample's weight. The rows are u of all samples, then
/// v.
struct PixelJacobian {
  Eigen::MatrixXd columns;    ///< One for each parameter.
  Eigen::VectorXd residuals;  ///< Model's pixel minus sample's pixel [px], with the same factor.

  /// The rows of u and v of one sample.
  [[nodiscard]] Eigen::Matrix<double, 2, Eigen::Dynamic> of(Eigen::Index sample) const {
    Eigen::Matrix<double, 2, Eigen::Dynamic> rows(2, columns.cols());
    rows << columns.row(sample), columns.row(columns.rows() / 2 + sample);
    return rows;
  }
};

/// nullopt if a sample's ray has no pixel, or a derivative is not finite.
[[nodiscard]] std::optional<PixelJacobian> jacobian_of(const CameraModel& model, std::span<const Correspondence> samples);

/// Only the residuals of jacobian_of(); nullopt if a sample's ray has no pixel.
[[nodiscard]] std::optional<Eigen::VectorXd> residuals_of(const CameraModel& model, std::span<const Correspondence> samples);

/// Indices of the parameters that a fit may have changed: all but those in `held`, lens parameters that are 0, and those that
/// fits of that model never change.
[[nodiscard]] std::vector<std::size_t> free_parameters(const CameraModel& model, std::span<const std::string> held);

}  // namespace fca::internal
