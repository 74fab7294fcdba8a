// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "choose_model.h"

#include <fca/diagnostics.h>
#include <fca/toolkit/convert.h>

#include <vector>

namespace fca {

/// Where the request asks for it, fits the stereo pair among the cameras together (fca/convert/pair_fit.h), with a note of what
/// that gains; false with an error where they are no pair or the request contradicts it.
[[nodiscard]] bool fit_as_pair(const Rig& input, const Format& to, const ModelChoice& choice,
                               std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
