// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "choose_model.h"

#include <fca/diagnostics.h>
#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// May the pair be fitted together as the request is otherwise? False with an error: it would need no fit to say so.
[[nodiscard]] bool may_fit_pair(const ConvertRequest& request, const Format& to, Diagnostics& diagnostics);

/// Where the request asks for it, fits the stereo pair among the cameras together (fca/convert/pair_fit.h), with a note of what
/// that gains; false with an error where they are no pair.
[[nodiscard]] bool fit_as_pair(const Rig& input, const Format& to, const ModelChoice& choice,
                               std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
