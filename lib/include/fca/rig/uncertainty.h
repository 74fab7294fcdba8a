// SPDX-License-Identifier: BSD-3-Clause
// What a calibration says of its own uncertainty.
#pragma once

#include <fca/diagnostics.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fca {

/// Of one camera's parameters, and of the residuals that they were estimated from.
struct Uncertainty {
  std::string camera;               ///< By its name in the rig.
  std::string model = {};           ///< Id of the model that the parameters belong to; empty: only residuals are specified.
  std::vector<double> sigmas = {};  ///< One standard deviation of each parameter in the order of the model's table, in the
                                    ///< parameter's unit; 0: it was held fixed. Empty: only residuals are specified.
  /// Row by row, in units of sigma_i sigma_j; its diagonal is that of `sigmas`. Empty: correlations are not known.
  std::vector<double> covariance = {};
  /// The values that the file contains besides the standard deviations, where it does; NaN of those that it leaves out.
  std::vector<double> values = {};
  std::optional<double> reprojection_rms_px = {};  ///< Root mean square distance between seen and computed points.
  SourceRange where = {};                          ///< Where that is specified.

  [[nodiscard]] bool has_covariance() const { return !covariance.empty(); }
  bool operator==(const Uncertainty&) const = default;
};

/// Of T_a_b.
struct PoseUncertainty {
  std::string a;
  std::string b;
  std::array<double, 3> rotation_rad{};   ///< One standard deviation about each axis.
  std::array<double, 3> translation_m{};  ///< Along each axis.
  SourceRange where = {};
  bool operator==(const PoseUncertainty&) const = default;
};

}  // namespace fca
