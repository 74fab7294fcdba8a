// SPDX-License-Identifier: BSD-3-Clause
// One way to write what was read: a model, a mode, a layout.
#pragma once

#include "choose_model.h"
#include "start.h"

namespace fca {

/// Which models the cameras may take, as the request, the base and the input allow.
[[nodiscard]] ModelChoice choice_of(const ConvertRequest& request, const Start& start, const Format& to);

/// Fits, writes in memory, places and proves it, into the result; false with errors.
[[nodiscard]] bool write_as_asked(const ConvertRequest& request, const Start& start, ConvertResult& result,
                                  Partial partial = Partial::kCone);

}  // namespace fca
