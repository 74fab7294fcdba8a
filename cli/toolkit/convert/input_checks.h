// SPDX-License-Identifier: BSD-3-Clause
// Checks that the input contains what a conversion needs.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// False, with an error, if the input has no camera, has several although the request gives a baseline for one, or has an IMU
/// that no pose connects while another one has poses.
[[nodiscard]] bool input_is_convertible(const ConvertRequest& request, const Calibration& input, ConvertResult& result);

}  // namespace fca
