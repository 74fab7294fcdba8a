// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

namespace fca {

/// A range for one parameter of the target, narrower than the model's own: what a program demands (EUCM alpha > 0.5, k3 = 0).
/// lower = upper fixes it.
struct ParameterRange {
  ParameterId parameter;
  double lower = 0.0;
  double upper = 0.0;
  bool operator==(const ParameterRange&) const = default;
};

}  // namespace fca
