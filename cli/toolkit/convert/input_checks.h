// SPDX-License-Identifier: BSD-3-Clause
// Checks that the input contains what a conversion needs.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// Returns false, with an error, in three cases: the input has no camera (and is no IMU file for a format that has such files);
/// the request gives a baseline, but the input has several cameras; no IMU of the input has a pose, but another IMU has one.
[[nodiscard]] bool input_is_convertible(const ConvertRequest& request, const Calibration& input, ConvertResult& result);

}  // namespace fca
