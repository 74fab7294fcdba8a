// SPDX-License-Identifier: BSD-3-Clause
// Writes the input in one way: with one model, mode and layout.
#pragma once

#include "choose_model.h"
#include "start.h"

namespace fca {

/// The models that the cameras may take, as request, base and input allow.
[[nodiscard]] ModelChoice choice_of(const ConvertRequest& request, const Start& start, const Format& to);

/// Fits the cameras, writes the files in memory, gives them paths and proves them. Fills `result`; false with errors.
[[nodiscard]] bool write_as_asked(const ConvertRequest& request, const Start& start, ConvertResult& result,
                                  Partial partial = Partial::kSmallerAngle);

}  // namespace fca
