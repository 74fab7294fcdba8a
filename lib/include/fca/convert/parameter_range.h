// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <vector>

namespace fca {

/// A range for one parameter of the target, narrower than the model's own: what a program demands (EUCM alpha > 0.5, k3 = 0).
/// lower = upper fixes it.
struct ParameterRange {
  ParameterId parameter;
  double lower = 0.0;
  double upper = 0.0;
  bool operator==(const ParameterRange&) const = default;
};

/// What the user wants to know fixed in a fit.
struct FixedParameters {
  std::vector<ParameterRange> at;  ///< At a number: lower = upper.
  std::vector<ParameterId> kept;   ///< At the source's, which must have that parameter.
  bool one_focal_length = false;   ///< fy is fx, whatever it is.
  bool operator==(const FixedParameters&) const = default;

  [[nodiscard]] bool any() const { return !at.empty() || !kept.empty() || one_focal_length; }
};

}  // namespace fca
