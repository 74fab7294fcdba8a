// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "choose_model.h"

#include <fca/diagnostics.h>
#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// Returns false, with an error, if the request asks for a fit of the pair and its other options do not allow that. To be
/// called before any camera is fitted.
[[nodiscard]] bool may_fit_pair(const ConvertRequest& request, const Format& to, Diagnostics& diagnostics);

/// If the request asks for it, fits both cameras of the stereo pair together (fca/convert/pair_fit.h) and adds a note with the
/// errors before and after. If that does not reduce the errors, keeps the separate fits and adds a note. Returns false, with an
/// error, if there is no pair among the cameras or the pair cannot be rectified.
[[nodiscard]] bool fit_as_pair(const Rig& input, const Format& to, const ModelChoice& choice,
                               std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
