// SPDX-License-Identifier: BSD-3-Clause
// The calibration's own uncertainty, in words and in JSON.
#pragma once

#include "json.h"

#include <fca/convert/report.h>
#include <fca/models/camera_model.h>

#include <string>

namespace fca::cli {

/// "conversion error 0.02 px, the calibration's own uncertainty 0.15 px (1 sigma, at the worst pixel), by covariance.csv"; of
/// an exact copy without the error. Where nothing specifies it: how much less the error is than what two calibrations of such a
/// camera differ by. Empty where there is nothing to compare.
[[nodiscard]] std::string uncertainty_in_words(const ConversionReport& report);

/// The members "uncertainty" and "repeatability" of an open object, where there are such; `target`: what was written.
void put_uncertainty(Json& json, const ConversionReport& report, const CameraModel& target);

}  // namespace fca::cli
