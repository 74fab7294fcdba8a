// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "choose_model.h"

#include <fca/diagnostics.h>
#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// True if the request's other options allow a fit of the pair; otherwise false, with an error. Checked before any fit is made.
[[nodiscard]] bool may_fit_pair(const ConvertRequest& request, const Format& to, Diagnostics& diagnostics);

/// If the request asks for it, fits the stereo pair among the cameras together (fca/convert/pair_fit.h) and adds a note with
/// the errors before and after. False, with an error, if there is no such pair.
[[nodiscard]] bool fit_as_pair(const Rig& input, const Format& to, const ModelChoice& choice,
                               std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
