// SPDX-License-Identifier: BSD-3-Clause
// Converts the input in one way, that is, in one mode and layout.
#pragma once

#include "choose_model.h"
#include "start.h"

namespace fca {

/// Returns which models the cameras may get (as the request, the base, the input and the program allow) and how they are
/// fitted.
[[nodiscard]] ModelChoice choice_of(const ConvertRequest& request, const Start& start, const Format& to);

/// Fits the cameras, makes the files in memory, gives them paths and checks them with the readers of programs. Fills `result`.
/// Returns false after errors.
[[nodiscard]] bool write_as_asked(const ConvertRequest& request, const Start& start, ConvertResult& result,
                                  Partial partial = Partial::kSmallerAngle);

}  // namespace fca
