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

/// Derivatives of pixels by each parameter, times the root of the sample's weight: u of all samples, then v.
struct PixelJacobian {
  Eigen::MatrixXd columns;    ///< One for each parameter.
  Eigen::VectorXd residuals;  ///< Pixel of the ray minus that of the sample, with the same weight.

  /// The two rows of a sample.
  [[nodiscard]] Eigen::Matrix<double, 2, Eigen::Dynamic> of(Eigen::Index sample) const {
    Eigen::Matrix<double, 2, Eigen::Dynamic> rows(2, columns.cols());
    rows << columns.row(sample), columns.row(columns.rows() / 2 + sample);
    return rows;
  }
};

/// Nothing where a sample's ray has no pixel.
[[nodiscard]] std::optional<PixelJacobian> jacobian_of(const CameraModel& model, std::span<const Correspondence> samples);

/// Its residuals alone.
[[nodiscard]] std::optional<Eigen::VectorXd> residuals_of(const CameraModel& model, std::span<const Correspondence> samples);

/// Indices of the parameters that a fit moved: not those of `held`, nor what is 0 or what fits of that model never move.
[[nodiscard]] std::vector<std::size_t> free_parameters(const CameraModel& model, std::span<const std::string> held);

}  // namespace fca::internal
