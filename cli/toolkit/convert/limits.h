// SPDX-License-Identifier: BSD-3-Clause
// Compares the errors of a conversion with the request's limits.
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Adds a warning for every camera whose new model does not describe its lens: more than 1 px rms, or 10 px at the worst pixel.
void warn_of_poor_fits(const ConvertRequest& request, ConvertResult& result);

/// False, with an error, if the request's limit is in standard deviations and a camera has no covariance.
[[nodiscard]] bool has_sigmas(const ConvertRequest& request, const Rig& rig, ConvertResult& result);

/// Sets the status kRejected, with an error for each violation, if the result exceeds the request's error limits, or loses
/// something although the request is strict.
void apply_limits(const ConvertRequest& request, ConvertResult& result);

}  // namespace fca
