// SPDX-License-Identifier: BSD-3-Clause
// Does the input hold what a conversion needs?
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// False with an error where the input does not serve: no camera, several where a baseline is given for one, or an IMU to which
/// no pose leads.
[[nodiscard]] bool serves(const ConvertRequest& request, const Calibration& input, ConvertResult& result);

}  // namespace fca
