// SPDX-License-Identifier: BSD-3-Clause
// Is a conversion good enough for what was asked?
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// A warning for every camera whose new model does not describe its lens: more than 1 px rms, or 10 px at the worst pixel.
void warn_of_poor_fits(const ConvertRequest& request, ConvertResult& result);

/// False, with an error, where the request's limit is in standard deviations and a camera has no covariance.
[[nodiscard]] bool has_sigmas(const ConvertRequest& request, const Rig& rig, ConvertResult& result);

/// kRejected, with an error of each, where the request's limits are exceeded: its error, or a loss where none is allowed.
void apply_limits(const ConvertRequest& request, ConvertResult& result);

}  // namespace fca
