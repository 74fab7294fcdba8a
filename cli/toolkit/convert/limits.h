// SPDX-License-Identifier: BSD-3-Clause
// Compares the errors of a conversion with the request's limits and with fixed ones.
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Adds a warning for every camera whose new model describes its lens poorly: with an rms above 1 px or an error above 10 px.
void warn_of_poor_fits(const ConvertRequest& request, ConvertResult& result);

/// Returns false, with an error, if the request has a limit in standard deviations (max_error_sigmas) and a camera has no
/// covariance or is a table of rays.
[[nodiscard]] bool has_needed_covariances(const ConvertRequest& request, const Rig& rig, ConvertResult& result);

/// Adds an error for each camera or program that exceeds an error limit of the request, and one for all losses if the request
/// is strict. After such an error the status is kRejected.
void apply_limits(const ConvertRequest& request, ConvertResult& result);

}  // namespace fca
